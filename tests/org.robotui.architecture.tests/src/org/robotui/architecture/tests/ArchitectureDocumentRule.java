package org.robotui.architecture.tests;

import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** ARCHITECTURE.md names every bundle in backquotes, and none that does not exist. */
final class ArchitectureDocumentRule implements Rule {

  private static final String FILE = "ARCHITECTURE.md";
  private static final Pattern NAME = Pattern.compile("`(org\\.robotui(?:\\.[a-z0-9_]+)+)`");

  @Override
  public String statement() {
    return "ARCHITECTURE.md names every bundle, and no other";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    Set<String> named = NAME.matcher(repository.read(FILE)).results().map(MatchResult::group)
        .map(quoted -> quoted.replace("`", "")).collect(Collectors.toCollection(TreeSet::new));
    Set<String> existing =
        repository.bundles().stream().map(Bundle::name).collect(Collectors.toCollection(TreeSet::new));
    return Stream.concat(
        missing(existing, named).map(name -> new Violation(FILE, "does not name the bundle " + name)),
        missing(named, existing).map(name -> new Violation(FILE, "names " + name + ", which is no bundle")));
  }

  private static Stream<String> missing(Set<String> wanted, Set<String> there) {
    return wanted.stream().filter(name -> !there.contains(name));
  }
}
