package org.robotui.workbench.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.host.Host;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.WindowConfig;

/**
 * All windows and what they show. A view has one control at a time, so a RUIC is shown in one window at a time: it is
 * for the user to say whether it moves. Display thread only.
 */
public final class Windows {
  private final Host host;
  private final List<WindowModel> models = new ArrayList<>();
  private int opened;

  /** Without windows. */
  public Windows(Host host) {
    this.host = host;
  }

  /** A window opens: it shows the first RUIC that no other window shows. */
  public WindowModel open() {
    WindowModel model = new WindowModel("window-" + ++opened);
    models.add(model);
    fill(model);
    return model;
  }

  /** A window closes. */
  public void close(WindowModel model) {
    unselect(model);
    models.remove(model);
  }

  /** Another window that shows a RUIC. */
  public Optional<WindowModel> elsewhere(WindowModel model, Ruic ruic) {
    return models.stream().filter(other -> other != model && other.shows(ruic)).findFirst();
  }

  /** Shows a RUIC in a window, in place of what it showed; a window that showed it shows none then. */
  public void select(WindowModel model, Ruic ruic) {
    if (model.shows(ruic)) {
      return;
    }
    models.stream().filter(other -> other.shows(ruic)).forEach(this::unselect);
    // The controls of the former go before its views are told, those of the next come after.
    model.show(Optional.empty());
    ruic.select(model.window());
    model.show(Optional.of(ruic));
  }

  /** Shows a RUIC in the window that shows another one; where a window shows it already, that comes to the front. */
  public void showInstead(String former, Ruic ruic) {
    models.stream().filter(m -> m.selected().filter(r -> r.name().equals(former)).isPresent()).findFirst()
        .ifPresent(m -> elsewhere(m, ruic).ifPresentOrElse(WindowModel::front, () -> select(m, ruic)));
  }

  /** Shows nothing in a window. */
  public void unselect(WindowModel model) {
    Optional<Ruic> former = model.selected();
    model.show(Optional.empty());
    former.ifPresent(ruic -> ruic.unselect(model.window()));
  }

  /** RUICs came or went: what is gone is not shown any more, and an empty window takes what is new. */
  public void ruicsChanged() {
    List<Ruic> present = host.ruics();
    for (WindowModel model : List.copyOf(models)) {
      boolean gone = model.selected().filter(r -> !present.contains(r)).isPresent();
      if (gone) {
        model.show(Optional.empty());
      }
    }
  }

  /**
   * Shows the first RUIC that no window shows, where the window shows none: first those for which the files ask for
   * windows.
   */
  public void fill(WindowModel model) {
    if (model.selected().isEmpty()) {
      Stream.concat(asked().stream().flatMap(w -> ruic(w.ruic()).stream()), host.ruics().stream())
          .filter(ruic -> models.stream().noneMatch(m -> m.shows(ruic)))
          .findFirst()
          .ifPresent(ruic -> select(model, ruic));
    }
  }

  /** The windows that the files ask for, of RUICs that are there. */
  public List<WindowConfig> asked() {
    return host.windows().stream().filter(w -> ruic(w.ruic()).isPresent()).toList();
  }

  private Optional<Ruic> ruic(String name) {
    return host.ruics().stream().filter(r -> r.name().equals(name)).findFirst();
  }
}
