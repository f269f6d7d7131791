package org.robotui.core.internal.life;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.UicType;
import org.robotui.api.host.RuicState;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.ShowChoice;
import org.robotui.api.show.Showing;
import org.robotui.api.show.Subject;
import org.robotui.core.internal.fence.Thrown;
import org.robotui.core.internal.port.StreamSource;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Finds the views of one RUIC that can show what a user points at, by what their types declare. Safe for all threads.
 */
final class Showings {
  private static final Logger LOG = LoggerFactory.getLogger(Showings.class);
  private static final Comparator<ShowChoice> ORDER = Comparator.comparing((ShowChoice c) -> !c.possible())
      .thenComparing(c -> c.showing().label()).thenComparing(ShowChoice::title);

  private final Services services;
  private final Components components;

  Showings(Services services, Components components) {
    this.services = services;
    this.components = components;
  }

  /** What can be done with it, those that can be done first. */
  List<ShowChoice> choices(Subject subject) {
    return services.registry().uics().stream()
        .filter(type -> services.stage().get().shows(type.surface()))
        .flatMap(type -> showings(type).stream().filter(s -> s.isFor(subject)).flatMap(s -> choices(type, s, subject)))
        .sorted(ORDER).toList();
  }

  /** Has the application show it in a view that is there and runs. */
  void show(String ruic, ShowChoice choice, Subject subject) {
    if (choice.possible() && running().anyMatch(slot -> slot.id().equals(choice.view()))) {
      services.events().viewWanted(ruic, choice.view(), choice.showing().id(), subject);
    }
  }

  /** The newest value of a stream. */
  Optional<Envelope<?>> newest(SourceId port) {
    return stream(port).flatMap(source -> source.last());
  }

  private static List<Showing> showings(UicType type) {
    try {
      return type.showings();
    } catch (RuntimeException | Error e) { // of a bundle that is not ours; the others are to be offered all the same
      Thrown.log(LOG, "The type of views '" + type.id() + "' does not say what it shows", e);
      return List.of();
    }
  }

  private Stream<ShowChoice> choices(UicType type, Showing showing, Subject subject) {
    Optional<String> misfit = misfit(showing, subject);
    List<ShowChoice> views = new ArrayList<>();
    running().filter(slot -> slot.config().type().equals(type.id()))
        .forEach(slot -> views.add(new ShowChoice(slot.id(), slot.title(), showing, misfit.orElse(""))));
    return views.isEmpty()
        ? Stream.of(new ShowChoice("", type.label(), showing, misfit.orElse("no such view in this UI")))
        : views.stream();
  }

  private Optional<String> misfit(Showing showing, Subject subject) {
    if (!(subject instanceof Subject.Stream wanted)) {
      return Optional.empty();
    }
    Optional<StreamSource<?>> stream = stream(wanted.port());
    if (stream.isEmpty()) {
      return Optional.of("not offered now");
    }
    return stream.filter(s -> !showing.takes(s.port().dataType())).map(s -> "shows no " + s.port().typeName());
  }

  private Stream<UicSlot> running() {
    return components.shown().stream()
        .filter(slot -> slot.uic().isPresent() && slot.health().state() != RuicState.FAILED);
  }

  private Optional<StreamSource<?>> stream(SourceId port) {
    return components.rfic(port.component()).stream().flatMap(slot -> slot.offers().stream())
        .<StreamSource<?>>mapMulti((offered, out) -> {
          if (offered instanceof StreamSource<?> source && source.id().equals(port)) {
            out.accept(source);
          }
        }).findFirst();
  }
}
