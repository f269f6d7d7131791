package org.robotui.architecture.tests;

import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Every bundle is shipped, once: in one feature. That of developers is on the update site only. */
final class FeatureRule implements Rule {

  private static final Pattern PLUGIN = Pattern.compile("<plugin\\s+id=\"(org\\.robotui\\.[^\"]+)\"");

  @Override
  public String statement() {
    return "every bundle is in exactly one feature";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    List<String> shipped = repository.features().stream().flatMap(FeatureRule::pluginsOf).toList();
    return repository.bundles().stream().map(Bundle::name)
        .filter(name -> shipped.stream().filter(name::equals).count() != 1)
        .map(name -> new Violation(name,
            "is in " + shipped.stream().filter(name::equals).count() + " of features/*/feature.xml"));
  }

  private static Stream<String> pluginsOf(Path feature) {
    return PLUGIN.matcher(Trees.read(feature)).results().map(found -> found.group(1));
  }
}
