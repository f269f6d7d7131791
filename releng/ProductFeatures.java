import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.jar.Attributes;
import java.util.jar.Manifest;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Writes into the products, their launch configurations and the category of the update site which features there are,
 * so that a new feature is a folder in {@code features} and nothing else. These are files that Tycho and the IDE read
 * as they are, which is why they hold the list (docs/adr/0112).
 *
 * <p>{@code java releng/ProductFeatures.java ROOT} writes; with {@code --check} it says what is not up to date, and
 * ends with 1.
 */
public final class ProductFeatures {

  private static final String WINDOW_PRODUCT = "product/org.robotui.workbench.product";

  private static final String HEADLESS_PRODUCT = "product/org.robotui.headless.product";

  private static final String WINDOW_LAUNCH = "releng/RobotUI.launch";

  private static final String HEADLESS_LAUNCH = "releng/RobotUI headless.launch";

  private static final String CATEGORY = "product/category.xml";

  private static final String PLATFORM = "org.robotui.feature.platform";

  /** For tests of bundles, which products have none of. */
  private static final String SDK = "org.robotui.feature.sdk";

  private static final String PRODUCT_LINE = "    <feature id=\"%s\" installMode=\"root\"/>\n";

  private static final String LAUNCH_LINE = "        <setEntry value=\"%s:default\"/>\n";

  private static final Pattern LAUNCH_LIST =
      Pattern.compile("(?s)( *<setAttribute key=\"selected_features\">\n).*?( *</setAttribute>\n)");

  private static final Pattern LIST = Pattern.compile("(?s)( *<features>\n).*?( *</features>\n)");

  private static final Pattern CATEGORY_LIST = Pattern.compile("(?s)(<site>\n).*?( *<category-def )");

  /** What a window is made of: who uses one of these is of no use without. */
  private static final Pattern WINDOW =
      Pattern.compile("org\\.eclipse\\.(swt|jface|ui)\\b.*|org\\.robotui\\.(ui|gl)(\\..*)?");

  private record Feature(String id, List<String> included, List<String> plugins) {

    boolean isPlatform() {
      return id.startsWith(PLATFORM);
    }
  }

  private final Path root;
  private final boolean check;
  private final List<String> stale = new ArrayList<>();

  private ProductFeatures(Path root, boolean check) {
    this.root = root;
    this.check = check;
  }

  public static void main(String[] arguments) throws IOException {
    boolean check = arguments.length > 1 && arguments[1].equals("--check");
    List<String> stale = new ProductFeatures(Path.of(arguments[0]), check).run();
    stale.forEach(file -> System.out.println(
        check ? file + " does not list the features that there are; write it anew: java releng/ProductFeatures.java ."
            : file + " was written"));
    System.exit(check && !stale.isEmpty() ? 1 : 0);
  }

  private List<String> run() throws IOException {
    List<Feature> all = features();
    List<Feature> shipped = all.stream().filter(feature -> !feature.id().equals(SDK)).toList();
    List<Feature> roots = shipped.stream()
        .filter(feature -> all.stream().noneMatch(other -> other.included().contains(feature.id()))).toList();
    List<Feature> windowless = new ArrayList<>();
    for (Feature feature : shipped) {
      if (!needsWindow(feature)) {
        windowless.add(feature);
      }
    }
    rewrite(WINDOW_PRODUCT, LIST, list(roots, PRODUCT_LINE));
    rewrite(HEADLESS_PRODUCT, LIST, list(windowless, PRODUCT_LINE));
    rewrite(WINDOW_LAUNCH, LAUNCH_LIST, launchList(roots));
    rewrite(HEADLESS_LAUNCH, LAUNCH_LIST, launchList(windowless));
    rewrite(CATEGORY, CATEGORY_LIST, list(all.stream().filter(feature -> !feature.isPlatform()).toList(),
        "  <feature id=\"%s\"><category name=\"org.robotui\"/></feature>\n"));
    return stale;
  }

  private static String list(List<Feature> features, String line) {
    return String.join("",
        features.stream()
            .sorted(Comparator.comparing((Feature feature) -> !feature.isPlatform()).thenComparing(Feature::id))
            .map(feature -> line.formatted(feature.id())).toList());
  }

  private static String launchList(List<Feature> features) {
    return String.join("", features.stream().map(Feature::id).sorted().map(LAUNCH_LINE::formatted).toList());
  }

  private void rewrite(String name, Pattern place, String list) throws IOException {
    Path file = root.resolve(name);
    String before = Files.readString(file);
    String after = place.matcher(before).replaceFirst("$1" + list.replace("$", "\\$") + "$2");
    if (!after.equals(before)) {
      stale.add(name);
      if (!check) {
        Files.writeString(file, after);
      }
    }
  }

  private List<Feature> features() throws IOException {
    try (Stream<Path> files = Files.walk(root.resolve("features"), 2)) {
      List<Feature> found = new ArrayList<>();
      for (Path file : files.filter(path -> path.endsWith("feature.xml")).sorted().toList()) {
        String text = Files.readString(file);
        found.add(new Feature(ids("feature", text).getFirst(), ids("includes", text), ids("plugin", text)));
      }
      return found;
    }
  }

  private static List<String> ids(String element, String text) {
    return Pattern.compile("<" + element + "\\s+id=\"([^\"]+)\"").matcher(text).results()
        .map((MatchResult found) -> found.group(1)).toList();
  }

  private boolean needsWindow(Feature feature) throws IOException {
    for (String plugin : feature.plugins()) {
      if (WINDOW.matcher(plugin).matches()
          || usesWindow(root.resolve("bundles").resolve(plugin).resolve("META-INF/MANIFEST.MF"))) {
        return true;
      }
    }
    return false;
  }

  private static boolean usesWindow(Path manifest) throws IOException {
    if (!Files.exists(manifest)) {
      return false;
    }
    try (InputStream in = Files.newInputStream(manifest)) {
      Attributes headers = new Manifest(in).getMainAttributes();
      return Stream.of("Import-Package", "Require-Bundle").map(headers::getValue).filter(value -> value != null)
          .flatMap(value -> Stream.of(value.replaceAll("\"[^\"]*\"", "").split(",")))
          .map(clause -> clause.replaceAll(";.*", "").strip())
          .anyMatch(name -> WINDOW.matcher(name).matches());
    }
  }
}
