package org.robotui.uic.scene3d.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Pick;
import org.robotui.gl.render.RenderRequest.Selected;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Properties;

/** What is selected, and what the pointer is over. Safe for all threads. */
public final class Picks {
  private Optional<Selection> selection = Optional.empty();
  private Optional<Selection> hover = Optional.empty();

  /** What a pick says; the words of a display that fails are left out. */
  public static Selection of(Pick pick) {
    return selected(pick.display().toString(), pick.part(), pick.element(), pick.place());
  }

  private static Selection selected(String display, Part part, int element, Vector3 place) {
    return new Selection(display, part, element, place, words(display, part, element, place));
  }

  private static Properties words(String display, Part part, int element, Vector3 place) {
    try {
      return part.describer().describe(element, place);
    } catch (RuntimeException e) {
      return Properties.of(display, new Properties.Entry("description", "failed: " + e));
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

  /**
   * Forgets what is no more, and goes along with what has moved; true where something else is to be said of the
   * selection then.
   */
  public synchronized boolean keep(Stage stage) {
    Optional<Selection> before = selection;
    selection = selection.flatMap(s -> now(s, stage));
    hover = hover.flatMap(s -> now(s, stage));
    return !before.map(Selection::said).equals(selection.map(Selection::said));
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

  private static Optional<Selection> now(Selection s, Stage stage) {
    return stage.parts().getOrDefault(s.display(), List.of()).stream().filter(p -> p.key().equals(s.part().key()))
        .findFirst()
        .map(part -> moved(s, part));
  }

  /** Of another shape nobody knows which element was meant: that of a cloud is another point. */
  private static Selection moved(Selection s, Part part) {
    if (part == s.part() || part.shape() != s.part().shape()) {
      return s;
    }
    Vector3 place = part.fixedFromShape().apply(s.part().fixedFromShape().inverse().apply(s.place()));
    return selected(s.display(), part, s.element(), place);
  }
}
