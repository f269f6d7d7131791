package org.robotui.uic.graph.internal.model;

import java.util.concurrent.Executor;
import org.robotui.ui.diagram.Diagram;
import org.robotui.ui.diagram.TextWidths;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Has nets laid out in the background, one at a time; of those that are asked for meanwhile, the newest. The one before
 * stays in sight until then.
 */
final class Laying {
  private static final Logger LOG = LoggerFactory.getLogger(Laying.class);

  /**
   * A layout.
   *
   * @param net of what
   * @param diagram the places
   * @param failure why there is none, empty where there is
   */
  record Laid(Net net, Diagram diagram, String failure) {}

  private record Wanted(Net net, TextWidths widths, boolean anew) {}

  private final Executor background;
  private volatile Laid laid = new Laid(Net.EMPTY, Diagram.EMPTY, "");
  private Wanted wanted = new Wanted(Net.EMPTY, TextWidths.estimate(), false);
  private boolean busy;
  private Wanted done = wanted;

  Laying(Executor background) {
    this.background = background;
  }

  /** The newest layout. */
  Laid laid() {
    return laid;
  }

  /** Whether a newer one is on its way. */
  synchronized boolean busy() {
    return busy;
  }

  /** Wants a net laid out; nothing happens where it was asked for before. */
  void want(Net net, TextWidths widths, boolean anew) {
    if (claim(new Wanted(net, widths, anew))) {
      background.execute(this::work);
    }
  }

  private synchronized boolean claim(Wanted next) {
    if (!next.anew() && next.net().equals(wanted.net()) && next.widths() == wanted.widths()) {
      return false;
    }
    wanted = next;
    boolean begins = !busy;
    busy = true;
    return begins;
  }

  private void work() {
    Wanted next = newest();
    try {
      Diagram before = next.anew() ? Diagram.EMPTY : laid.diagram();
      Layouter.lay(next.net(), next.widths(), before).ifPresent(diagram -> laid = new Laid(next.net(), diagram, ""));
    } catch (RuntimeException e) { // the library's own faults: the one before stays in sight, with the reason
      LOG.warn("Laying out {} boxes failed", next.net().vertices().size(), e);
      laid = new Laid(laid.net(), laid.diagram(), "The newest graph could not be laid out: " + e);
    }
    if (goesOn(next)) {
      background.execute(this::work);
    }
  }

  private synchronized Wanted newest() {
    return wanted;
  }

  private synchronized boolean goesOn(Wanted finished) {
    done = finished;
    busy = wanted != done;
    return busy;
  }
}
