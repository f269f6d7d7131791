package org.robotui.architecture.tests;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A build can put all bundles in an order. What tests use counts ({@code additional.bundles} of build.properties), as
 * the build makes it before the bundle that is tested.
 */
final class BuildOrderRule implements Rule {

  private static final Pattern FOR_TESTS = Pattern.compile("(?m)^additional\\.bundles\\s*=((?:.*\\\\\\R)*.*)$");

  @Override
  public String statement() {
    return "no bundle uses, by way of others, one whose tests use it";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    Map<String, Set<String>> needs =
        repository.bundles().stream().collect(Collectors.toMap(Bundle::name, bundle -> needsOf(bundle, repository)));
    return repository.bundles().stream().flatMap(bundle -> forTests(bundle, repository)
        .filter(helper -> reach(helper, needs).contains(bundle.name()))
        .map(helper -> new Violation(bundle.name(),
            "its tests use " + helper + ", which needs it: neither can be built first")));
  }

  private static Set<String> needsOf(Bundle bundle, Repository repository) {
    Stream<String> used = Uses.of(bundle).flatMap(use -> repository.owner(use.name()).stream()).map(Bundle::name);
    return Stream.concat(used, forTests(bundle, repository)).filter(name -> !name.equals(bundle.name()))
        .collect(Collectors.toSet());
  }

  private static Stream<String> forTests(Bundle bundle, Repository repository) {
    Path file = repository.root().resolve("bundles").resolve(bundle.name()).resolve("build.properties");
    return Files.exists(file)
        ? FOR_TESTS.matcher(Trees.read(file)).results().flatMap(found -> Stream.of(found.group(1).split("[,\\s\\\\]+")))
            .filter(name -> !name.isEmpty())
        : Stream.empty();
  }

  private static Set<String> reach(String from, Map<String, Set<String>> needs) {
    Set<String> reached = new HashSet<>();
    Collection<String> next = needs.getOrDefault(from, Set.of());
    while (reached.addAll(next)) {
      next = next.stream().flatMap(name -> needs.getOrDefault(name, Set.of()).stream()).collect(Collectors.toSet());
    }
    return reached;
  }
}
