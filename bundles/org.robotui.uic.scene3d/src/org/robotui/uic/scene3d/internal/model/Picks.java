package org.robotui.uic.scene3d.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Pick;
import org.robotui.gl.render.RenderRequest.Selected;
import org.robotui.gl.shape.Properties;

/** What is selected, and what the pointer is over. Safe for all threads. */
public final class Picks {
  private Optional<Selection> selection = Optional.empty();
  private Optional<Selection> hover = Optional.empty();

  /** What a pick says; the words of a display that fails are left out. */
  public static Selection of(Pick pick) {
    return new Selection(pick.display().toString(), pick.part(), pick.place(), words(pick));
  }

  private static Properties words(Pick pick) {
    try {
      return pick.part().describer().describe(pick.element(), pick.place());
    } catch (RuntimeException e) {
      return Properties.of(pick.display().toString(), new Properties.Entry("description", "failed: " + e));
    }
  }

  /** Selects. */
  public synchronized void select(Optional<Selection> next) {
    selection = next;
  }

  /** Points at. */
  public synchronized void hover(Optional<Selection> next) {
    hover = next;
  }

  /** What is selected. */
  public synchronized Optional<Selection> selection() {
    return selection;
  }

  /** What the pointer is over. */
  public synchronized Optional<Selection> hovered() {
    return hover;
  }

  /** Forgets what is no more; true where something went. */
  public synchronized boolean keep(Stage stage) {
    Optional<Selection> before = selection;
    selection = selection.filter(s -> there(s, stage));
    hover = hover.filter(s -> there(s, stage));
    return !before.equals(selection);
  }

  /** For the renderer: what is selected, else what would be. */
  public synchronized List<Selected> marked() {
    List<Selected> marked = new ArrayList<>();
    selection.ifPresent(s -> marked.add(s.selected()));
    hover.filter(h -> selection.filter(h::same).isEmpty()).ifPresent(h -> marked.add(h.selected()));
    return marked;
  }

  /** What to look at when the selection is focused. */
  public synchronized Optional<Vector3> place() {
    return selection.map(Selection::place);
  }

  private static boolean there(Selection s, Stage stage) {
    return stage.parts().getOrDefault(s.display(), List.of()).stream().anyMatch(p -> p.key().equals(s.part().key()));
  }
}
