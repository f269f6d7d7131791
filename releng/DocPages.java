import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.ext.heading.anchor.HeadingAnchorExtension;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Link;
import org.commonmark.node.Node;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;

/**
 * Writes the texts of the repository as pages that a browser shows, for the products (docs/adr/0115): DocPages.java
 * REPOSITORY FOLDER. Links between texts become links between pages; of a link to anything else only its words stay.
 */
public final class DocPages {
  private static final List<String> AT_THE_TOP =
      List.of("README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "THIRD-PARTY.md");
  private static final Map<String, String> GROUPS = new LinkedHashMap<>();
  private static final Pattern HEADING = Pattern.compile("^# (.+)$", Pattern.MULTILINE);
  private static final String STYLE = """
      body { font: 16px/1.55 system-ui, sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1.5em; color: #1f2730; background: #fff; }
      a { color: #0b63c4; } nav { margin-bottom: 2em; } img { max-width: 100%; }
      code, pre { font: 14px/1.45 ui-monospace, monospace; background: #f2f4f7; border-radius: 4px; } code { padding: 0 .25em; }
      pre { padding: .8em 1em; overflow-x: auto; } pre code { padding: 0; }
      table { border-collapse: collapse; } th, td { border: 1px solid #d5dae0; padding: .3em .7em; text-align: left; vertical-align: top; }
      @media (prefers-color-scheme: dark) {
        body { color: #d7dde4; background: #1b1f24; } a { color: #4da3ff; } code, pre { background: #22272e; } th, td { border-color: #3a424c; }
      }
      """;

  static {
    GROUPS.put("docs/views/displays/", "Displays of the 3D scene");
    GROUPS.put("docs/views/", "Views");
    GROUPS.put("docs/adr/", "Why it is as it is");
    GROUPS.put("docs/", "Guides");
    GROUPS.put("", "RobotUI");
  }

  private final Path from;
  private final Path to;
  private final Map<String, String> titles = new TreeMap<>();
  private final Parser parser;
  private final HtmlRenderer renderer;

  private DocPages(Path from, Path to) {
    this.from = from;
    this.to = to;
    List<Extension> extensions = List.of(TablesExtension.create(), HeadingAnchorExtension.create());
    parser = Parser.builder().extensions(extensions).build();
    renderer = HtmlRenderer.builder().extensions(extensions).escapeHtml(true).build();
  }

  public static void main(String[] arguments) throws IOException {
    DocPages pages = new DocPages(Path.of(arguments[0]).toRealPath(), Path.of(arguments[1]));
    pages.find();
    pages.write();
  }

  private void find() throws IOException {
    List<Path> texts = new ArrayList<>(AT_THE_TOP.stream().map(from::resolve).toList());
    try (Stream<Path> below = Files.walk(from.resolve("docs"))) {
      below.filter(file -> file.toString().endsWith(".md")).forEach(texts::add);
    }
    for (Path text : texts) {
      Matcher heading = HEADING.matcher(Files.readString(text));
      titles.put(from.relativize(text).toString(),
          heading.find() ? heading.group(1).replace("`", "") : text.getFileName().toString());
    }
  }

  private void write() throws IOException {
    for (Map.Entry<String, String> text : titles.entrySet()) {
      Node document = parser.parse(Files.readString(from.resolve(text.getKey())));
      document.accept(new PageLinks(text.getKey()));
      String up = "../".repeat((int) text.getKey().chars().filter(c -> c == '/').count());
      save(page(text.getKey()), text.getValue(),
          "<nav><a href=\"" + up + "index.html\">All pages</a></nav>\n" + renderer.render(document));
    }
    save("index.html", "RobotUI documentation", index());
    copyImages();
  }

  private String index() {
    StringBuilder body = new StringBuilder("<h1>RobotUI documentation</h1>\n");
    List<String> groups = List.of("", "docs/", "docs/views/", "docs/views/displays/", "docs/adr/");
    for (String group : groups) {
      body.append("<h2>").append(GROUPS.get(group)).append("</h2>\n<ul>\n");
      titles.entrySet().stream().filter(text -> group(text.getKey()).equals(group))
          .forEach(text -> body.append("<li><a href=\"")
              .append(page(text.getKey())).append("\">").append(escape(text.getValue())).append("</a></li>\n"));
      body.append("</ul>\n");
    }
    return body.toString();
  }

  private static String group(String text) {
    return GROUPS.keySet().stream().filter(text::startsWith).findFirst().orElseThrow();
  }

  private void save(String page, String title, String body) throws IOException {
    Path file = to.resolve(page);
    Files.createDirectories(file.getParent());
    Files.writeString(file,
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width\">\n<title>"
            + escape(title) + "</title>\n<style>\n" + STYLE + "</style>\n</head>\n<body>\n" + body
            + "</body>\n</html>\n");
  }

  private void copyImages() throws IOException {
    Path images = Files.createDirectories(to.resolve("docs/images"));
    try (Stream<Path> all = Files.list(from.resolve("docs/images"))) {
      for (Path image : all.toList()) {
        Files.write(images.resolve(image.getFileName()), Files.readAllBytes(image));
      }
    }
  }

  private static String page(String text) {
    return text.replaceAll("\\.md$", ".html");
  }

  private static String escape(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;");
  }

  /** Turns links to texts into links to their pages. */
  private final class PageLinks extends AbstractVisitor {
    private final URI at;

    PageLinks(String text) {
      at = URI.create("/" + text);
    }

    @Override
    public void visit(Link link) {
      visitChildren(link);
      URI target = at.resolve(link.getDestination());
      if (target.isAbsolute() || link.getDestination().startsWith("#")) {
        return;
      }
      String path = target.getPath().substring(1);
      boolean picture = path.startsWith("docs/images/") && Files.exists(from.resolve(path));
      if (titles.containsKey(path)) {
        link.setDestination(link.getDestination().replaceFirst("\\.md(?=#|$)", ".html"));
      } else if (!picture) {
        unlink(link);
      }
    }

    private void unlink(Link link) {
      while (link.getFirstChild() != null) {
        link.insertBefore(link.getFirstChild());
      }
      link.unlink();
    }
  }
}
