import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.lang.model.SourceVersion;

/**
 * Makes a new bundle from the example of its kind, which is an ordinary bundle that is built and tested with all
 * others: only names are replaced (docs/adr/0118). In the repository it writes the feature and the sentence in
 * ARCHITECTURE.md, too; outside, a project that builds against the update site.
 *
 * <p>{@code java releng/NewBundle.java ROOT KIND NAME [--in FOLDER] [--site URI]} ends with 2 and a sentence where it
 * cannot be done as asked.
 */
public final class NewBundle {

  private static final String VIEWS = "org.robotui.feature.views";

  private static final String CORE = "org.robotui.feature.core";

  /**
   * A kind of bundle, its example, and the feature that has the others of its kind; each robot interface has a feature
   * of its own.
   */
  private enum Kind {
    RFIC("org.robotui.rfic.line", Optional.empty(), "robots that speak %s"),
    UIC("org.robotui.uic.trip", Optional.of(VIEWS), "the view %s"),
    ENTITY("org.robotui.entity.reach", Optional.of(VIEWS), "the layer %s of maps"),
    DISPLAY("org.robotui.entity.speed", Optional.of(VIEWS), "the display %s in space"),
    RUIC("org.robotui.ruic.cockpit", Optional.of(CORE), "the UI %s");

    private final String example;
    private final Optional<String> feature;
    private final String sentence;

    Kind(String example, Optional<String> feature, String sentence) {
      this.example = example;
      this.feature = feature;
      this.sentence = sentence;
    }

    static Kind of(String word) throws Refusal {
      return Stream.of(values()).filter(kind -> kind.word().equals(word)).findFirst()
          .orElseThrow(() -> new Refusal("there is no kind of bundle '" + word + "'; there are " + words()));
    }

    static String words() {
      return Stream.of(values()).map(Kind::word).collect(Collectors.joining(", "));
    }

    String word() {
      return name().toLowerCase(Locale.ROOT);
    }

    /** What the names of such bundles begin with in the repository. */
    String family() {
      return example.substring(0, example.lastIndexOf('.') + 1);
    }
  }

  /** What cannot be done, and what would help. */
  private static final class Refusal extends Exception {

    private static final long serialVersionUID = 1L;

    Refusal(String sentence) {
      super(sentence);
    }
  }

  /** The names of a bundle: its own, the id of its type, and what its classes begin with. */
  private record Names(String bundle, String id, String prefix) {

    static Names of(String bundle) {
      String id = bundle.substring(bundle.lastIndexOf('.') + 1);
      String prefix = Stream.of(id.split("_")).filter(part -> !part.isEmpty())
          .map(part -> part.substring(0, 1).toUpperCase(Locale.ROOT) + part.substring(1)).collect(Collectors.joining());
      return new Names(bundle, id, prefix);
    }

    String label() {
      return id.substring(0, 1).toUpperCase(Locale.ROOT) + id.substring(1).replace('_', ' ');
    }

    /**
     * Replaces these names by others. The id is replaced only where it is one: examples use such words in sentences,
     * too.
     */
    String replaced(String text, Names by) {
      String renamed = text.replace(bundle, by.bundle).replace(bundle.replace('.', '/'), by.bundle.replace('.', '/'));
      Map<String, String> patterns = Map.of(
          "\\b" + prefix + "(?=[A-Z])", by.prefix,
          "(?<=[\"`])" + id + "(?=[\"`])", by.id,
          "(?<=[\"])" + label() + "(?=[\"])", by.label(),
          "(?<=type: )" + id + "\\b", by.id,
          "(?m)(?<=^  )" + id + "(?=: )", by.id,
          "(?m)(?<=^# )" + label() + "$", by.label(),
          "(?m)(?<=^Bundle-Name: ).*: " + id + "$", by.label());
      for (Map.Entry<String, String> pattern : patterns.entrySet()) {
        renamed = renamed.replaceAll(pattern.getKey(), Matcher.quoteReplacement(pattern.getValue()));
      }
      return renamed;
    }
  }

  private final Path root;
  private final Kind kind;
  private final Names names;

  private NewBundle(Path root, Kind kind, Names names) {
    this.root = root;
    this.kind = kind;
    this.names = names;
  }

  public static void main(String[] arguments) throws IOException {
    try {
      run(new ArrayList<>(Arrays.asList(arguments))).forEach(System.out::println);
    } catch (Refusal e) {
      System.err.println("robotui: " + e.getMessage());
      System.exit(2);
    }
  }

  private static List<String> run(List<String> arguments) throws IOException, Refusal {
    Optional<Path> folder = option(arguments, "--in").map(Path::of).map(path -> path.toAbsolutePath().normalize());
    Path root = Path.of(arguments.removeFirst()).toAbsolutePath().normalize();
    String site = option(arguments, "--site").orElse(root.resolve("product/target/repository").toUri().toString());
    if (arguments.size() != 2) {
      throw new Refusal(
          "a kind of bundle (" + Kind.words() + ") and a name are needed, as in ./robotui new rfic lidar");
    }
    Kind kind = Kind.of(arguments.getFirst());
    Names names = Names.of(folder.isPresent() ? outside(arguments.getLast(), kind) : inside(arguments.getLast(), kind));
    NewBundle made = new NewBundle(root, kind, names);
    return folder.isPresent() ? made.inProject(folder.get(), site) : made.inRepository();
  }

  private static Optional<String> option(List<String> arguments, String name) throws Refusal {
    int at = arguments.indexOf(name);
    if (at < 0) {
      return Optional.empty();
    }
    if (at + 1 == arguments.size()) {
      throw new Refusal(name + " needs a value");
    }
    arguments.remove(at);
    return Optional.of(arguments.remove(at));
  }

  // ---- names

  private static String inside(String name, Kind kind) throws Refusal {
    if (name.contains(".")) {
      throw new Refusal("in this repository a bundle is called " + kind.family() + "NAME, so '" + name
          + "' has to be a plain word; with --in FOLDER it is made outside, by that name");
    }
    return kind.family() + checked(name);
  }

  private static String outside(String name, Kind kind) throws Refusal {
    if (!name.contains(".") || name.startsWith("org.robotui.")) {
      throw new Refusal("a bundle outside of this repository needs a name of your own with a dot, such as acme."
          + name.replaceAll(".*\\.", "")
          + ", so that nobody else's has the same");
    }
    return checked(name);
  }

  private static String checked(String name) throws Refusal {
    for (String part : name.split("\\.", -1)) {
      if (!part.matches("[a-z][a-z0-9_]*") || SourceVersion.isKeyword(part)) {
        throw new Refusal("'" + name
            + "' cannot be the name of a package: each part begins with a small letter, has small letters, digits and _, "
            + "and is no word of Java");
      }
    }
    return name;
  }

  // ---- in the repository

  private List<String> inRepository() throws IOException, Refusal {
    Path bundle = newFolder(root.resolve("bundles").resolve(names.bundle()));
    copyExample(bundle);
    Path features = root.resolve("features");
    Path feature = kind.feature.isPresent() ? addToFeature(features.resolve(kind.feature.get()))
        : ownFeature(features.resolve("org.robotui.feature." + names.id()), "RobotUI for ");
    addSentence();
    return List.of("The bundle is in " + bundle + ", and in the feature " + feature.getFileName() + ".",
        "ARCHITECTURE.md names it by a sentence that you should complete.",
        "Build and test it with all others:  ./robotui test unit; ./robotui test architecture",
        "Its README.md says how a configuration uses it; then:  ./robotui run CONFIG");
  }

  private static Path newFolder(Path folder) throws Refusal {
    if (Files.exists(folder)) {
      throw new Refusal(folder + " is there already; choose another name, or take it away");
    }
    return folder;
  }

  private Path addToFeature(Path folder) throws IOException {
    addLine(folder.resolve("feature.xml"), "  <plugin id=\"" + names.bundle() + "\" version=\"0.0.0\"/>",
        "  <plugin id=\"" + kind.family());
    return folder;
  }

  private void addSentence() throws IOException {
    String start = "| %s | `".formatted(level());
    addLine(root.resolve("ARCHITECTURE.md"),
        start + names.bundle() + "` | " + kind.sentence.formatted(names.id().replace('_', ' ')) + " |",
        start + kind.family());
  }

  private String level() throws IOException {
    String pattern = " " + kind.family() + "*";
    return Files.readString(root.resolve("bundles/LAYERS")).lines().filter(line -> line.endsWith(pattern)).findFirst()
        .orElseThrow().split("\\s+")[0];
  }

  /** Puts a line where it belongs among the sorted ones that begin alike. */
  private static void addLine(Path file, String line, String alike) throws IOException {
    List<String> lines = new ArrayList<>(Files.readAllLines(file));
    List<Integer> places = new ArrayList<>();
    for (int i = 0; i < lines.size(); i++) {
      if (lines.get(i).startsWith(alike)) {
        places.add(i);
      }
    }
    int at = places.stream().filter(i -> lines.get(i).compareTo(line) > 0).findFirst().orElse(places.getLast() + 1);
    lines.add(at, line);
    Files.writeString(file, String.join("\n", lines) + "\n");
  }

  // ---- outside

  private List<String> inProject(Path folder, String site) throws IOException, Refusal {
    if (folder.startsWith(root)) {
      throw new Refusal(folder + " lies in this repository; choose a folder outside, or leave out --in");
    }
    Path target = folder.resolve("robotui.target");
    if (!Files.exists(target) && Files.isDirectory(folder) && !isEmpty(folder)) {
      throw new Refusal(folder
          + " has other files and no robotui.target; choose a new or an empty folder, or one that was made by this command");
    }
    Path bundle = newFolder(folder.resolve("bundles").resolve(names.bundle()));
    if (!Files.exists(target)) {
      copyProject(folder, site);
    }
    copyExample(bundle);
    fitForIde(bundle);
    Path feature = ownFeature(folder.resolve("features").resolve(names.bundle() + ".feature"), "");
    sayEncoding(feature);
    Path category = folder.resolve("site/category.xml");
    Files.writeString(category, Files.readString(category).replaceFirst("(?=\n</site>)",
        "\n  <feature id=\"" + feature.getFileName() + "\"><category name=\"bundles\"/></feature>"));
    return List.of("The bundle is in " + bundle + ".",
        "The README.md of " + folder + " says how it is built, tested and installed.");
  }

  private static boolean isEmpty(Path folder) throws IOException {
    try (Stream<Path> children = Files.list(folder)) {
      return children.findAny().isEmpty();
    }
  }

  private void copyProject(Path folder, String site) throws IOException {
    String target = Files.readString(root.resolve("releng/robotui.target"));
    Matcher junit =
        Pattern.compile("(?s) *<location type=\"Maven\" label=\"JUnit[^>]*>.*?</location>\n").matcher(target);
    String version = Pattern.compile("<tycho.version>(.*?)<").matcher(Files.readString(root.resolve("pom.xml")))
        .results().findFirst().orElseThrow().group(1);
    Map<String, String> values = Map.of("site", site, "junit", junit.find() ? junit.group() : "", "tycho", version,
        "group", names.bundle().substring(0, names.bundle().lastIndexOf('.')), "units", units(), "root",
        root.toString());
    Path templates = root.resolve("tools/project-templates");
    for (Path template : filesIn(templates)) {
      String text = Files.readString(template);
      for (Map.Entry<String, String> value : values.entrySet()) {
        text = text.replace("@" + value.getKey() + "@", value.getValue());
      }
      write(folder.resolve(templates.relativize(template).toString().replaceFirst("\\.in$", "")
          .replaceFirst("^(mvn/|gitignore$|project$)", ".$1")), text);
    }
    sayEncoding(folder);
  }

  /**
   * What this repository says once for a whole workspace, a project of its own says itself: its encoding, and that
   * descriptors of components are generated. Its unit tests need no project of this repository.
   */
  private void fitForIde(Path bundle) throws IOException {
    sayEncoding(bundle);
    write(bundle.resolve(".settings/org.eclipse.pde.ds.annotations.prefs"), """
        classpath=true
        dsVersion=V1_4
        eclipse.preferences.version=1
        enabled=true
        path=OSGI-INF
        """);
    write(bundle.resolve(".settings/org.eclipse.jdt.core.prefs"), """
        eclipse.preferences.version=1
        org.eclipse.jdt.core.compiler.codegen.targetPlatform=21
        org.eclipse.jdt.core.compiler.compliance=21
        org.eclipse.jdt.core.compiler.problem.unusedLambdaParameter=ignore
        org.eclipse.jdt.core.compiler.release=enabled
        org.eclipse.jdt.core.compiler.source=21
        """);
    replace(bundle.resolve("Unit tests of " + names.bundle() + ".launch"),
        "--enable-native-access=ALL-UNNAMED [^\"]*project_loc:/org\\.robotui[^\"]*",
        "--enable-native-access=ALL-UNNAMED");
  }

  private static void sayEncoding(Path project) throws IOException {
    write(project.resolve(".settings/org.eclipse.core.resources.prefs"), """
        eclipse.preferences.version=1
        encoding/<project>=UTF-8
        """);
  }

  private static void replace(Path file, String pattern, String by) throws IOException {
    Files.writeString(file, Pattern.compile(pattern, Pattern.DOTALL).matcher(Files.readString(file)).replaceFirst(by));
  }

  /** All features, as units of the target platform. */
  private String units() throws IOException {
    try (Stream<Path> features = Files.list(root.resolve("features"))) {
      return features.filter(folder -> Files.exists(folder.resolve("feature.xml"))).map(Path::getFileName).sorted()
          .map(id -> "      <unit id=\"" + id + ".feature.group\" version=\"0.0.0\"/>\n").collect(Collectors.joining());
    }
  }

  // ---- both

  private void copyExample(Path to) throws IOException {
    Names example = Names.of(kind.example);
    Path from = root.resolve("bundles").resolve(kind.example);
    for (Path file : filesIn(from)) {
      write(to.resolve(example.replaced(from.relativize(file).toString(), names)),
          example.replaced(Files.readString(file), names));
    }
  }

  /** Without what builds make, and without the flaws by which an example tests the tests. */
  private static List<Path> filesIn(Path folder) throws IOException {
    Pattern left = Pattern.compile(
        "(target|bin|bin_test|OSGI-INF|\\.settings)(/.*)?|src_test/(.*/)?Flaw[^/]*|\\.(polyglot|tycho).*|pom\\.tycho");
    try (Stream<Path> files = Files.walk(folder)) {
      return files.filter(Files::isRegularFile)
          .filter(file -> !left.matcher(folder.relativize(file).toString()).matches()).sorted().toList();
    }
  }

  private Path ownFeature(Path folder, String labelled) throws IOException {
    Path from = root.resolve("features/org.robotui.feature.player");
    String id = folder.getFileName().toString();
    write(folder.resolve(".project"),
        Files.readString(from.resolve(".project")).replace(from.getFileName().toString(), id));
    write(folder.resolve("build.properties"), Files.readString(from.resolve("build.properties")));
    write(folder.resolve("feature.xml"), """
        <?xml version="1.0" encoding="UTF-8"?>
        <feature id="%s" label="%s" version="0.1.0.qualifier">
          <description>%s</description>
          <plugin id="%s" version="0.0.0"/>
        </feature>
        """.formatted(id, labelled + names.label(), names.label() + ", a bundle of RobotUI.", names.bundle()));
    return folder;
  }

  private static void write(Path file, String text) throws IOException {
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }
}
