package org.robotui.core.internal.life;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.stream.Stream;
import org.robotui.api.UicType;
import org.robotui.api.UicType.Surface;
import org.robotui.api.host.RuicState;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.ShowChoice;
import org.robotui.api.show.Showing;
import org.robotui.api.show.Subject;
import org.robotui.core.internal.command.CommandTarget;
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
  private final ArrangedViews arranged;

  Showings(Services services, Components components, ArrangedViews arranged) {
    this.services = services;
    this.components = components;
    this.arranged = arranged;
  }

  /** What can be done with it, those that can be done first. */
  List<ShowChoice> choices(Subject subject) {
    return services.registry().uics().stream()
        .filter(type -> services.stage().get().shows(type.surface()))
        .flatMap(type -> showings(type).stream().filter(s -> s.isFor(subject)).flatMap(s -> choices(type, s, subject)))
        .sorted(ORDER).toList();
  }

  /**
   * Opens the view where it is not open, and has the application show it there: on the worker, where that comes after
   * the start of the view.
   */
  void show(String ruic, ShowChoice choice, Subject subject, Executor worker) {
    choice.opens().ifPresent(type -> arranged.open(choice.view(), type));
    worker.execute(() -> {
      if (choice.possible() && running().anyMatch(slot -> slot.id().equals(choice.view()))) {
        services.events().viewWanted(ruic, choice.view(), choice.showing().id(), subject);
      }
    });
  }

  /** The newest value of a stream. */
  Optional<Envelope<?>> newest(SourceId port) {
    return stream(port).flatMap(source -> source.last());
  }

  /** The newest command that went out. */
  Optional<Envelope<?>> sent(SourceId port) {
    return components.rfic(port.component()).stream().flatMap(slot -> slot.offers().stream())
        .filter(o -> o.id().equals(port)).filter(CommandTarget.class::isInstance)
        .flatMap(o -> ((CommandTarget<?>) o).sent().last().stream()).<Envelope<?>>map(e -> e).findFirst();
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
    return views.isEmpty() ? Stream.of(opening(type, showing, misfit)) : views.stream();
  }

  /** No view of the type runs: one that is closed is opened, or one more. */
  private ShowChoice opening(UicType type, Showing showing, Optional<String> misfit) {
    boolean broken = components.shown().stream().anyMatch(slot -> slot.config().type().equals(type.id()));
    Optional<String> obstacle = misfit.or(() -> type.surface() != Surface.WINDOW
        ? Optional.of("no such view in this UI")
        : broken ? Optional.of("the view does not work") : Optional.empty());
    return obstacle.map(why -> new ShowChoice("", type.label(), showing, why)).orElseGet(
        () -> new ShowChoice(arranged.closed(type.id()), type.label(), showing, "", Optional.of(type.id())));
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
