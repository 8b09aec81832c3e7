#include <hachure/runtime/assets/json_text.h>
#include <hachure/runtime/error.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include <hachure/tests/support/temp_folder.h>

#include "gltf_builder.h"

namespace hachure::assets {
namespace {

using test::TempFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string fault_of(std::string text) {
    try {
        (void)JsonText::parse("f.json", std::move(text));
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

TEST(JsonText, NamesThePlacesOfNestedValues) {
    const JsonText text =
        JsonText::parse("f.json", "{\n  \"a\": [1, {\"b\": true,\n    \"c\": null}],\n  \"d\": \"x\"\n}");
    EXPECT_EQ(text.subject(), "f.json");
    EXPECT_EQ(text.root()["a"][1]["b"], true);
    EXPECT_EQ(text.where(""), "line 1, column 1");
    EXPECT_EQ(text.where("/a"), "line 2, column 8: /a");
    EXPECT_EQ(text.where("/a/0"), "line 2, column 9: /a/0");
    EXPECT_EQ(text.where("/a/1"), "line 2, column 12: /a/1");
    EXPECT_EQ(text.where("/a/1/b"), "line 2, column 18: /a/1/b");
    EXPECT_EQ(text.where("/a/1/c"), "line 3, column 10: /a/1/c");
    EXPECT_EQ(text.where("/d"), "line 4, column 8: /d");
}

TEST(JsonText, WhatIsNotThereStandsWhereItWouldBe) {
    const JsonText text = JsonText::parse("f.json", "{\"a\": [1, 2],\n \"e\": [], \"o\": {}}");
    EXPECT_EQ(text.where("/a/2"), "line 1, column 7: /a/2");
    EXPECT_EQ(text.where("/a/x/y"), "line 1, column 7: /a/x/y");
    EXPECT_EQ(text.where("/b"), "line 1, column 1: /b");
    EXPECT_EQ(text.where("/a/0/z"), "line 1, column 8: /a/0/z");
    EXPECT_EQ(text.where("/e/0"), "line 2, column 7: /e/0");
    EXPECT_EQ(text.where("/o/k"), "line 2, column 16: /o/k");
    EXPECT_EQ(text.where("nonsense"), "line 1, column 1: nonsense");
}

TEST(JsonText, KeysMayHoldWhatPointersAndStringsEscape) {
    const JsonText text = JsonText::parse(
        "f.json", R"({"a/b": {"~": 1}, "q\"u,]}": [10, 20], "\u0041": 3, "str": "a\"{[,\\", "": {"": 5}, "end": 4})");
    EXPECT_EQ(text.where("/a~1b/~0"), "line 1, column 15: /a~1b/~0");
    EXPECT_EQ(text.where("/q\"u,]}/1"), "line 1, column 35: /q\"u,]}/1");
    EXPECT_EQ(text.where("/A"), "line 1, column 50: /A");
    EXPECT_EQ(text.where("//"), "line 1, column 81: //");
    EXPECT_EQ(text.where("/end"), "line 1, column 92: /end");
}

TEST(JsonText, ColumnsCountCharactersAndLinesEndInCrLfToo) {
    EXPECT_EQ(JsonText::parse("f", "{\r\n\t\"a\":\t1,\r\n\"b\": 2}").where("/a"), "line 2, column 7: /a");
    EXPECT_EQ(JsonText::parse("f", "{\r\n\t\"a\":\t1,\r\n\"b\": 2}").where("/b"), "line 3, column 6: /b");
    EXPECT_EQ(JsonText::parse("f", "{\"\xc3\xa4\xe2\x82\xac\": 1}").where("/\xc3\xa4\xe2\x82\xac"),
              "line 1, column 8: /\xc3\xa4\xe2\x82\xac");
    EXPECT_EQ(JsonText::parse("f", "\xef\xbb\xbf{\"a\": 1}").where("/a"), "line 1, column 7: /a");
}

TEST(JsonText, RefusesKeysThatAreThereTwice) {
    EXPECT_EQ(fault_of("{\"a\": 1,\n \"b\": 2,\n \"a\": 3}"), "f.json: has the key 'a' twice (line 3, column 2)");
    EXPECT_EQ(fault_of(R"({"x": [0, {"y/z": {"k": 1, "\u006b": 2}}]})"),
              "f.json: has the key 'k' twice (line 1, column 28)");
    EXPECT_EQ(fault_of(R"([{"a": 1}, {"a": 1}])"), "none");
}

TEST(JsonText, RefusesNestingWithoutEnd) {
    const std::size_t most = JsonText::max_depth;
    EXPECT_EQ(fault_of(std::string(most, '[') + std::string(most, ']')), "none");
    EXPECT_EQ(fault_of(std::string(most + 1, '[') + std::string(most + 1, ']')),
              "f.json: is nested deeper than 512 levels (line 1, column 513)");
    EXPECT_THAT(fault_of(std::string(1'000'000, '[')), HasSubstr("nested deeper"));
    std::string objects;
    for (std::size_t i = 0; i <= most; ++i) objects += "{\"a\":\n";
    EXPECT_EQ(fault_of(objects), "f.json: is nested deeper than 512 levels (line 513, column 1)");
}

TEST(JsonText, SaysWhereItIsNoJson) {
    EXPECT_THAT(fault_of(""), StartsWith("f.json: is no JSON: while parsing value - unexpected end of input"));
    EXPECT_THAT(fault_of("{\"a\": 1,\n \"b\" 2}"), AllOf(HasSubstr("is no JSON"), HasSubstr("(line 2, column 6)")));
    EXPECT_THAT(fault_of("{\"a\": [1, 2"), HasSubstr("(line 1, column 12)"));
    EXPECT_THAT(fault_of("{} {}"), HasSubstr("(line 1, column 4)"));
    EXPECT_THAT(fault_of("{\"a\": NaN}"), HasSubstr("is no JSON"));
    EXPECT_THAT(fault_of("{\"a\": 1e999}"), HasSubstr("number overflow"));
    EXPECT_THAT(fault_of("{\"a\": \"" + std::string(100'000, 'x')).size(), testing::Lt(400u));
}

TEST(JsonText, RefusesWhatIsNotUtf8) {
    EXPECT_EQ(fault_of("{\n\"a\": \"\xff\"}"),
              "f.json: is no JSON: while parsing value - invalid string: ill-formed UTF-8 byte (line 2, column 7)");
    EXPECT_THAT(fault_of("{\"\xc3\x28\": 1}"), HasSubstr("UTF-8"));
    EXPECT_THAT(fault_of(std::string("{\"a\0b\": 1}", 10)), HasSubstr("is no JSON"));
}

TEST(JsonText, FailsWithSubjectAndPlace) {
    const JsonText text = JsonText::parse("f.json", "{\"a\": {\"b\": 2}}");
    try {
        text.fail("/a/b", "is too much");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "f.json: is too much (line 1, column 13: /a/b)");
    }
}

TEST(JsonText, ReadsFiles) {
    const TempFolder folder;
    gltf_testing::write_file(folder / "a.json", std::string("{\"a\": [1]}"));
    EXPECT_EQ(JsonText::read(folder / "a.json").root()["a"][0], 1);
    EXPECT_EQ(JsonText::read(folder / "a.json").subject(), (folder / "a.json").string());
    EXPECT_THROW((void)JsonText::read(folder / "none.json"), Error);
    EXPECT_THROW((void)JsonText::read(folder.path()), Error);
}

TEST(JsonText, LargeDocumentsAreReadAtOnce) {
    std::string document = "[";
    while (document.size() < 16'000'000)
        document += R"({"name": "entity", "transform": {"translation": [1.5, -2.25, 0.125]}, "gooch": {"b": 0.5}},)"
                    "\n";
    document += "{\"last\": 1}]";
    const auto begin = std::chrono::steady_clock::now();
    const JsonText text = JsonText::parse("large.json", std::move(document));
    const std::string place = text.where("/" + std::to_string(text.root().size() - 1) + "/last");
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(place.substr(0, place.find(':')), "line " + std::to_string(text.root().size()) + ", column 10");
    EXPECT_LT(seconds.count(), 5.0) << "some 0.4 s on a quiet machine; sanitizers take their time";
}

} // namespace
} // namespace hachure::assets
