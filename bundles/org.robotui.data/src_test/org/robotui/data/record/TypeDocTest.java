package org.robotui.data.record;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class TypeDocTest {
  private static final Path SOURCES = Path.of("src", "org", "robotui", "data");
  private static final Path WRITTEN = SOURCES.resolve("record").resolve("types.txt");
  private static final Path WANTED = Path.of("target", "types.txt");
  private static final Pattern DECLARED = Pattern.compile(
      "/\\*\\*(?<doc>(?:[^*]|\\*(?!/))*)\\*/\\s*(?:@\\w+(?:\\([^)]*\\))?\\s*)*public (?:sealed |final )?(?<kind>record|interface|class|enum) (?<name>\\w+)(?:<[^>{(]*>)?"
          + "\\s*(?:\\((?<components>[^{]*?)\\)\\s*(?:implements[^{]*)?\\{)?|/\\*\\*(?<inner>(?:[^*]|\\*(?!/))*)\\*/\\s*record (?<innername>\\w+)"
          + "\\((?<innercomponents>[^{]*?)\\)\\s*(?:implements[^{]*)?\\{");

  @Test
  void saysWhatATypeMeansAndItsUnits() {
    TypeDoc scan = TypeDoc.find("LaserScan").getFirst();
    assertTrue(scan.text().startsWith("One sweep of a planar laser scanner."), scan.text());
    assertEquals(new TypeDoc.Field("rangeMax", "double", "longest measurable distance, metres"), scan.fields().get(4));
  }

  @Test
  void saysWhatATypeIsMadeOf() {
    assertEquals(List.of("JointState", "JointState.Joint"),
        TypeDoc.find("JointState").stream().map(TypeDoc::name).toList());
  }

  @Test
  void knowsNoOtherTypes() {
    assertEquals(List.of(), TypeDoc.find("nav_msgs/Odometry"));
  }

  @Test
  void allFieldsOfAllTypesAreDescribed() throws IOException {
    for (TypeDoc doc : described()) {
      doc.fields().forEach(
          field -> assertTrue(!field.text().isBlank(), doc.name() + "." + field.name() + " has no description"));
    }
  }

  /** The file is made of the sources, so that neither is ever without the other. */
  @Test
  void theDescriptionsAreThoseOfTheSources() throws IOException {
    String wanted = described().stream().map(TypeDocTest::text).collect(Collectors.joining());
    Files.createDirectories(WANTED.getParent());
    Files.writeString(WANTED, wanted);
    assertEquals(wanted, Files.readString(WRITTEN),
        "the sources have changed; copy " + WANTED + " to " + WRITTEN + " of this bundle");
  }

  private static String text(TypeDoc doc) {
    return "= " + doc.name() + "\n" + doc.text() + "\n"
        + doc.fields().stream().map(f -> "- " + f.name() + "\t" + f.type() + "\t" + f.text() + "\n")
            .collect(Collectors.joining());
  }

  private static List<TypeDoc> described() throws IOException {
    List<TypeDoc> all = new ArrayList<>();
    try (Stream<Path> files = Files.walk(SOURCES)) {
      for (Path file : files.filter(f -> f.toString().endsWith(".java") && !f.endsWith("package-info.java"))
          .sorted(Comparator.comparing(Path::getFileName)).toList()) {
        all.addAll(described(file.getFileName().toString().replace(".java", ""), Files.readString(file)));
      }
    }
    return all;
  }

  private static List<TypeDoc> described(String outer, String source) {
    List<TypeDoc> all = new ArrayList<>();
    Matcher found = DECLARED.matcher(source);
    while (found.find()) {
      if (found.group("inner") != null) {
        all.add(doc(outer + "." + found.group("innername"), found.group("inner"), found.group("innercomponents")));
      } else if (found.group("components") != null || found.group("kind").equals("interface")) {
        String name = found.group("name").equals(outer) ? outer : outer + "." + found.group("name");
        all.add(doc(name, found.group("doc"), found.group("components") == null ? "" : found.group("components")));
      }
    }
    return all;
  }

  private static TypeDoc doc(String name, String comment, String components) {
    String plain = comment.replaceAll("(?m)^\\s*\\*? ?", "").strip();
    int tags = (plain + "\n@").indexOf("\n@");
    String text = words(plain.startsWith("@") ? "" : plain.substring(0, Math.min(plain.length(), tags)));
    Map<String, String> texts = new HashMap<>();
    for (String tag : plain.split("(?m)^@")) {
      if (tag.startsWith("param ") && !tag.startsWith("param <")) {
        String[] said = tag.substring("param ".length()).strip().split("\\s+", 2);
        texts.put(said[0], words(said.length > 1 ? said[1] : ""));
      }
    }
    List<TypeDoc.Field> fields = new ArrayList<>();
    for (String component : components.split(",(?![^<]*>)")) {
      if (!component.isBlank()) {
        String declared = component.strip().replaceAll("\\s+", " ");
        int last = declared.lastIndexOf(' ');
        fields.add(new TypeDoc.Field(declared.substring(last + 1), declared.substring(0, last),
            texts.getOrDefault(declared.substring(last + 1), "")));
      }
    }
    return new TypeDoc(name, text, fields);
  }

  /** Without marks that only Javadoc reads; a paragraph in a line. */
  private static String words(String javadoc) {
    return Stream.of(javadoc.split("<p>")).map(paragraph -> paragraph
        .replaceAll("\\{@(?:code|link|linkplain)\\s+#?([^}]*)}", "$1").replaceAll("</?[a-z]+>", "")
        .replaceAll("\\s+", " ").strip())
        .filter(paragraph -> !paragraph.isEmpty()).collect(Collectors.joining("\n"));
  }
}
