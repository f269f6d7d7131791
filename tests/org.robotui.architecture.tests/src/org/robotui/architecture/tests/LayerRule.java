package org.robotui.architecture.tests;

import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;

/**
 * Arrows point strictly down the lines of bundles/LAYERS, in manifests and in sources, and only from those whom a line
 * is for.
 */
final class LayerRule implements Rule {

  @Override
  public String statement() {
    return "a bundle imports only from layers below its own that are for it";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    return repository.bundles().stream().flatMap(bundle -> violationsOf(bundle, repository));
  }

  private Stream<Violation> violationsOf(Bundle bundle, Repository repository) {
    if (repository.layers().height(bundle.name()).isEmpty()) {
      return Stream.of(new Violation(bundle.name(), "no line of bundles/LAYERS names it"));
    }
    return Uses.of(bundle).flatMap(use -> violation(bundle, use, repository).stream());
  }

  private static Optional<Violation> violation(Bundle from, Uses.Use use, Repository repository) {
    return repository.owner(use.name())
        .filter(to -> !to.name().equals(from.name()))
        .flatMap(to -> wrongArrow(from, to, use, repository.layers()));
  }

  private static Optional<Violation> wrongArrow(Bundle from, Bundle to, Uses.Use use, Layers layers) {
    int own = layers.height(from.name()).orElseThrow();
    OptionalInt other = layers.height(to.name());
    if (other.isEmpty()) {
      return Optional.empty();
    }
    Layers.Layer user = layers.at(own);
    Layers.Layer used = layers.at(other.getAsInt());
    String arrow = "layer %s uses %s of layer %s".formatted(user.level(), use.name(), used.level());
    if (other.getAsInt() >= own) {
      return Optional.of(new Violation(use.where(), arrow));
    }
    return used.isFor(user.level()) ? Optional.empty()
        : Optional.of(new Violation(use.where(), arrow + ", which is for " + used.audience()));
  }
}
