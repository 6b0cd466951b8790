#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "console/gateway/server.h"
#include "tests/gateway/client.h"

namespace tacit::gateway {
namespace {
namespace fs = std::filesystem;

class StaticFilesTest : public ::testing::Test {
 protected:
  StaticFilesTest() {
    fs::create_directories(folder_ / "pages/assets");
    write("secret.txt", "secret");
    write("pages/index.html", "<p>index</p>");
    write("pages/.hidden", "hidden");
    write("pages/a file.svg", "<svg/>");
    write("pages/assets/main-1a2b.js", "plain");
    write("pages/assets/main-1a2b.js.gz", "packed");
    fs::create_symlink(folder_ / "secret.txt", folder_ / "pages/link.txt");
    ServerConfig config;
    config.pages = folder_ / "pages";
    server_.emplace(config);
    server_->route(Method::Get, "/api/runs", [](const Request&) { return json("[]"); });
    server_->route(Method::Get, "/api/big", [this](const Request&) {
      return Response{.content_type = "text/plain", .file = folder_ / "big"};
    });
    server_->start();
  }
  ~StaticFilesTest() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  Reply get(const std::string& target, const Fields& headers = {}) {
    return gateway::get(server_->port(), target, headers);
  }

  fs::path folder_ =
      fs::path(::testing::TempDir()) / ("gateway_static_" + std::to_string(::getpid()));
  std::optional<Server> server_;
};

TEST_F(StaticFilesTest, AFileComesWithItsType) {
  const Reply reply = get("/a%20file.svg");
  EXPECT_EQ(reply.status, 200);
  EXPECT_EQ(reply.headers.at("content-type"), "image/svg+xml");
  EXPECT_EQ(reply.body, "<svg/>");
  EXPECT_EQ(ask(server_->port(), {.method = "HEAD", .target = "/a%20file.svg"})
                .headers.at("content-length"),
            "6");
}

TEST_F(StaticFilesTest, ThePageAnswersForAddressesOfItsOwn) {
  for (const std::string target : {"/", "/index.html", "/runs/17", "/runs/"}) {
    const Reply reply = get(target);
    EXPECT_EQ(reply.body, "<p>index</p>") << target;
    EXPECT_EQ(reply.headers.at("content-type"), "text/html; charset=utf-8");
  }
  EXPECT_EQ(get("/missing.js").status, 404);
  EXPECT_EQ(get("/api/none").status, 404);
}

TEST_F(StaticFilesTest, NothingOutsideTheFolderIsThere) {
  for (const std::string target :
       {"/../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "/assets/../../secret.txt",
        "/assets/%2e%2e/%2e%2e/secret.txt", "/link.txt", "/.hidden", "//etc/passwd.txt",
        "/%2fetc%2fpasswd.txt"}) {
    const Reply reply = get(target);
    EXPECT_EQ(reply.status, 404) << target;
    EXPECT_EQ(reply.body.find("secret\""), std::string::npos);
  }
}

TEST_F(StaticFilesTest, AnUnchangedFileIsNotSentAgain) {
  const Reply first = get("/index.html");
  const std::string tag = first.headers.at("etag");
  EXPECT_EQ(first.headers.at("cache-control"), "no-cache");
  const Reply again = get("/index.html", {{"If-None-Match", "\"other\", " + tag}});
  EXPECT_EQ(again.status, 304);
  EXPECT_EQ(again.body, "");
  EXPECT_EQ(again.headers.at("etag"), tag);
  write("pages/index.html", "<p>changed</p>");
  EXPECT_EQ(get("/index.html", {{"If-None-Match", tag}}).body, "<p>changed</p>");
}

TEST_F(StaticFilesTest, HashedFilesMayBeKeptForEver) {
  EXPECT_EQ(get("/assets/main-1a2b.js").headers.at("cache-control"),
            "public, max-age=31536000, immutable");
}

TEST_F(StaticFilesTest, APackedFileGoesToThoseWhoTakeIt) {
  const Reply packed = get("/assets/main-1a2b.js", {{"Accept-Encoding", "br, gzip"}});
  EXPECT_EQ(packed.body, "packed");
  EXPECT_EQ(packed.headers.at("content-encoding"), "gzip");
  EXPECT_EQ(packed.headers.at("content-type"), "text/javascript; charset=utf-8");
  const Reply plain = get("/assets/main-1a2b.js", {{"Accept-Encoding", "br, gzip;q=0"}});
  EXPECT_EQ(plain.body, "plain");
  EXPECT_EQ(plain.headers.at("vary"), "Accept-Encoding");
  EXPECT_NE(plain.headers.at("etag"), packed.headers.at("etag"));
}

TEST_F(StaticFilesTest, ARouteMayAnswerWithALargeFile) {
  EXPECT_EQ(get("/api/big").status, 404);
  const std::string text(20'000'000, 'x');
  write("big", text);
  EXPECT_EQ(get("/api/big").body, text);
}

TEST_F(StaticFilesTest, WithoutPagesThereIsABuiltInOne) {
  ServerConfig config;
  config.pages = folder_ / "nowhere";
  config.name = "A & <b>";
  Server bare(config);
  bare.start();
  const Reply reply = gateway::get(bare.port(), "/");
  EXPECT_EQ(reply.status, 200);
  EXPECT_NE(reply.body.find("<h1>A &amp; &lt;b></h1>"), std::string::npos);
  EXPECT_EQ(gateway::get(bare.port(), "/favicon.ico").status, 404);
}

}  // namespace
}  // namespace tacit::gateway
