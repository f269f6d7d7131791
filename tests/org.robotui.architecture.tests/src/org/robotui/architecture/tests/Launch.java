package org.robotui.architecture.tests;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** A launch configuration of the IDE: its file and what is in it. */
record Launch(String path, String text) {

  private static final Pattern ENTRY = Pattern.compile("<setEntry value=\"([^\":]+):");

  private static final Pattern PROJECT_FOLDER = Pattern.compile("\\$\\{project_loc:/([^}]+)}");

  private static final Pattern PROJECT =
      Pattern.compile("\"org\\.eclipse\\.jdt\\.launching\\.PROJECT_ATTR\" value=\"([^\"]+)\"");

  /** All that lie in releng/. */
  static List<Launch> allOf(Repository repository) {
    return Trees.files(repository.root().resolve("releng"), ".launch").stream().map(file -> at(repository.root(), file))
        .toList();
  }

  private static Launch at(Path root, Path file) {
    return new Launch(root.relativize(file).toString(), Trees.read(file));
  }

  /** Whether it starts an application, not tests. */
  boolean isApplication() {
    return text.contains("type=\"org.eclipse.pde.ui.RuntimeWorkbench\"");
  }

  Optional<String> application() {
    return value("application");
  }

  /** The project whose code it starts. */
  Optional<String> project() {
    return PROJECT.matcher(text).results().map(found -> found.group(1)).findFirst();
  }

  Set<String> features() {
    return ENTRY.matcher(set("selected_features")).results().map(Launch::first).collect(Collectors.toSet());
  }

  /** Bundles and projects of ours that it names. */
  Stream<String> projects() {
    Stream<String> bundles = ENTRY.matcher(set("additional_plugins")).results().map(Launch::first)
        .filter(id -> id.startsWith("org.robotui."));
    return Stream.of(bundles, PROJECT_FOLDER.matcher(text).results().map(Launch::first), project().stream())
        .flatMap(all -> all);
  }

  private String set(String key) {
    return Pattern.compile("<setAttribute key=\"" + key + "\">(.*?)</setAttribute>", Pattern.DOTALL).matcher(text)
        .results()
        .map(Launch::first).collect(Collectors.joining());
  }

  private Optional<String> value(String key) {
    return Pattern.compile("<stringAttribute key=\"" + key + "\" value=\"([^\"]*)\"").matcher(text).results()
        .map(Launch::first).findFirst();
  }

  private static String first(MatchResult found) {
    return found.group(1);
  }
}
