package org.robotui.uic.connections.internal.model;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.robotui.api.bridge.BridgeStatus;
import org.robotui.api.host.RuicSnapshot;

/** What is shown and what is wanted to be shown. The tick brings news, the display thread wishes; safe for both. */
public final class ConnectionsModel {
  private final Survey survey = new Survey();
  private ConnectionsLook look = ConnectionsLook.NONE;
  private Filter filter = Filter.ALL;
  private Set<String> folded = Set.of();
  private volatile Shown shown = new Shown(ConnectionsLook.NONE, List.of(), Filter.ALL, Set.of());

  /**
   * What is to be painted.
   *
   * @param look all there is
   * @param lines those wanted
   * @param filter which are wanted
   * @param folded the keys of lines below which nothing is shown
   */
  public record Shown(ConnectionsLook look, List<ConnectionLine> lines, Filter filter, Set<String> folded) {
    /** Whether a line is shut while it has something below. */
    public boolean isFolded(ConnectionLine line) {
      return !filter.narrows() && folded.contains(line.key());
    }
  }

  /** Takes what all RUICs and bridges say. True where that is something new to show. */
  public synchronized boolean tick(List<RuicSnapshot> ruics, List<BridgeStatus> bridges, long now) {
    ConnectionsLook next = survey.look(ruics, bridges, now);
    boolean changed = !next.equals(look);
    look = next;
    if (changed) {
      update();
    }
    return changed;
  }

  /** Wants other lines. Takes some milliseconds where there are very many. */
  public synchronized void filter(Filter wanted) {
    filter = wanted;
    update();
  }

  /** Folds a line, or unfolds it. */
  public synchronized void fold(String key, boolean shut) {
    Set<String> next = new HashSet<>(folded);
    if (shut ? next.add(key) : next.remove(key)) {
      folded = Set.copyOf(next);
      update();
    }
  }

  /** Folds all RUICs, or unfolds everything. */
  public synchronized void foldAll(boolean shut) {
    folded = shut ? Set.copyOf(look.names()) : Set.of();
    update();
  }

  /** What is to be painted. */
  public Shown shown() {
    return shown;
  }

  private void update() {
    shown = new Shown(look, look.lines(filter, folded), filter, folded);
  }
}
