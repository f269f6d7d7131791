package org.robotui.workbench.internal.dock;

import java.util.Optional;
import org.robotui.api.host.Arranging;
import org.robotui.api.layout.Arrangement;
import org.robotui.api.layout.Arrangement.Added;
import org.robotui.api.layout.DropTarget;
import org.robotui.api.layout.Edge;

/**
 * What users do to the arrangement of one RUIC's views. Each change holds at once, is kept, and can be undone. Display
 * thread only.
 */
public final class Docking {
  private final Arranging arranging;
  private final ArrangeHistory history;
  private final Runnable arranged;
  private boolean locked;

  /**
   * Of a RUIC.
   *
   * @param arranging its arrangement
   * @param history what was before
   * @param arranged lays out what is arranged now
   */
  Docking(Arranging arranging, ArrangeHistory history, Runnable arranged) {
    this.arranging = arranging;
    this.history = history;
    this.arranged = arranged;
  }

  /** How the views are arranged now. */
  public Arrangement now() {
    return arranging.now();
  }

  /** What there is to arrange. */
  public Arranging arranging() {
    return arranging;
  }

  /** Has views stay where they lie, whatever is done to them; perspectives can be chosen all the same. */
  void lock(boolean now) {
    locked = now;
  }

  boolean isLocked() {
    return locked;
  }

  /** Arranges the views otherwise. */
  void change(Arrangement next) {
    Arrangement before = now();
    if (!locked && !next.equals(before)) {
      history.changes(before);
      quietly(next);
    }
  }

  /** What nobody would want to undo: which tab is in front, where a window lies. */
  void quietly(Arrangement next) {
    arranging.arrange(next);
    arranged.run();
  }

  /** Has a view lie elsewhere. */
  void move(String view, DropTarget target) {
    change(now().with(view, target));
  }

  /** Closes a view; what it shows ends. */
  public void close(String view) {
    change(now().closed(view));
  }

  /** Opens a view that is closed, where it lies in the configuration. */
  public void open(String view) {
    change(now().opened(view, arranging.written().layout()));
  }

  /** Opens one more view of a type, among the tabs of another one where that is there. Returns its id. */
  public String add(String type, Optional<String> beside) {
    String id = arranging.freshId(type);
    Arrangement more = now().adding(new Added(id, type));
    change(beside.filter(now().views()::contains).or(() -> now().views().stream().findFirst())
        .map(view -> more.with(id, new DropTarget.Tab(view, Integer.MAX_VALUE)))
        .orElseGet(() -> more.with(id, new DropTarget.Border(0, Edge.LEFT))));
    return id;
  }

  /** Whether there is something to undo. */
  public boolean canUndo() {
    return !locked && history.canUndo();
  }

  /** Whether there is something to redo. */
  public boolean canRedo() {
    return !locked && history.canRedo();
  }

  /** Takes the last change back. */
  public void undo() {
    if (canUndo()) {
      history.undo(now()).ifPresent(this::quietly);
    }
  }

  /** Makes the last change that was taken back. */
  public void redo() {
    if (canRedo()) {
      history.redo(now()).ifPresent(this::quietly);
    }
  }

  /** Has the configuration hold again. */
  public void reset() {
    if (!locked) {
      history.changes(now());
      arranging.reset();
      arranged.run();
    }
  }

  /** Arranges the views as a perspective has them. */
  public void choose(String perspective) {
    history.changes(now());
    arranging.choose(perspective);
    arranged.run();
  }
}
