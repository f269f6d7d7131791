package org.robotui.core.internal.life;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.robotui.api.layout.Arrangement;
import org.robotui.api.layout.Arrangement.Added;
import org.robotui.api.layout.Layout;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.KeptViews.Hand;
import org.robotui.core.internal.config.model.RawSection;

/**
 * The views that the configuration plans, under an arrangement of the user.
 *
 * @param planned the views of the configuration
 * @param written where they lie by the configuration
 * @param nothing settings of which none are written
 */
record ArrangedPlan(List<ComponentConfig> planned, Arrangement written, RawSection nothing) {
  /** Nothing is planned. */
  static ArrangedPlan none(Optional<Layout> layout, RawSection nothing) {
    return new ArrangedPlan(List.of(), new Arrangement(layout.orElse(new Layout.Tabs(List.of()))), nothing);
  }

  /** The ids of all views that an arrangement may have. */
  Set<String> ids(List<Added> added) {
    Set<String> ids = new LinkedHashSet<>();
    planned.forEach(view -> ids.add(view.id()));
    written.views().forEach(ids::add);
    added.forEach(view -> ids.add(view.id()));
    return ids;
  }

  /** What of an arrangement can be: no view that is not there, none added that the configuration has. */
  Arrangement possible(Arrangement wanted) {
    List<Added> added = wanted.added().stream().filter(a -> planned.stream().noneMatch(p -> p.id().equals(a.id())))
        .toList();
    return new Arrangement(wanted.layout(), wanted.windows(), added).only(ids(added));
  }

  /** What was arranged before, with the views that have come since beside those that they lie with by the file. */
  Arrangement merged(Hand hand) {
    Arrangement merged = possible(hand.arrangement());
    for (String view : written.views()) {
      if (!hand.known().contains(view) && !merged.views().contains(view)) {
        merged = merged.opened(view, written.layout());
      }
    }
    return merged;
  }

  /**
   * The views that run under an arrangement: those that lie somewhere, and those that need no place.
   *
   * @param needsPlace whether a view is one for windows
   */
  List<ComponentConfig> running(Arrangement now, Predicate<ComponentConfig> needsPlace) {
    List<ComponentConfig> running = new ArrayList<>(planned);
    now.added().forEach(view -> running.add(config(view)));
    Set<String> places = Set.copyOf(now.views());
    return running.stream().filter(view -> places.contains(view.id()) || !needsPlace.test(view)).toList();
  }

  /** All views that have or could have a place. */
  Stream<ComponentConfig> placeable(Arrangement now, Predicate<ComponentConfig> needsPlace) {
    return Stream.concat(planned.stream(), now.added().stream().map(this::config)).filter(needsPlace);
  }

  private ComponentConfig config(Added view) {
    return new ComponentConfig(view.id(), view.type(), "", "", nothing, "", 0, 0);
  }
}
