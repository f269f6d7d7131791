package org.robotui.uic.tftree.internal.model;

import java.util.List;
import java.util.Optional;
import java.util.function.LongToDoubleFunction;
import org.robotui.api.UicContext;
import org.robotui.api.frame.Frames;
import org.robotui.api.port.InputState;
import org.robotui.api.time.RobotClock;
import org.robotui.data.FrameId;
import org.robotui.ui.diagram.Diagram;
import org.robotui.ui.diagram.TextWidths;

/**
 * The frames, taken twice a second, and the pose of the selected one at each tick. The tick prepares all that is seen;
 * what is asked for may be said on any thread and counts from the next tick on.
 */
public final class TfTreeModel {
  private static final long SURVEY_NANOS = 500_000_000L;
  private static final InputState NOTHING =
      new InputState.Waiting("No transform came yet. Robots that publish /tf or /tf_static appear here.");
  private static final InputState LIVE = new InputState.Live(0, 0);

  private final Frames frames;
  private final DetailMaker details;
  private volatile Ask ask = Ask.FIRST;
  private volatile TextWidths widths = TextWidths.estimate();
  private volatile TfTreeViewState look =
      new TfTreeViewState(Ask.FIRST, NOTHING, List.of(), Diagram.EMPTY, List.of(), Optional.empty(), 0, 0);
  private Forest forest = Forest.EMPTY;
  private List<FrameRow> all = List.of();
  private final RobotClock clock;
  private TextWidths measured = widths;
  private long surveyed;
  private boolean ever;

  /** With what core gives to the view. */
  public TfTreeModel(UicContext context) {
    frames = context.frames();
    clock = context.clock();
    details = new DetailMaker(frames, clock);
  }

  /** Takes what is known; whether there is something new to show. */
  public boolean tick(long now, double staleAfter) {
    Ask wanted = ask;
    TfTreeViewState before = look;
    boolean due = !ever || now - surveyed >= SURVEY_NANOS || !wanted.equals(before.ask()) || measured != widths;
    TfTreeViewState next = due ? survey(wanted, now, staleAfter) : before;
    Optional<FrameDetail> detail = wanted.selected().filter(forest::contains)
        .map(frame -> details.of(frame, wanted.reference(), forest, row(frame)));
    next = new TfTreeViewState(wanted, next.state(), next.rows(), next.drawing(), next.notices(), detail, next.frames(),
        next.trees());
    boolean changed = !next.equals(before);
    look = next;
    return changed;
  }

  private TfTreeViewState survey(Ask wanted, long now, double staleAfter) {
    surveyed = now;
    ever = true;
    measured = widths;
    LongToDoubleFunction ages = received -> clock.ageSeconds(received, now);
    forest = Forest.of(frames.all(), frames.links());
    all = RowMaker.all(forest, wanted, staleAfter, ages);
    List<FrameRow> rows = RowMaker.shown(forest, all, wanted);
    Diagram drawing = wanted.drawn() ? TreeDrawing.draw(rows, measured) : Diagram.EMPTY;
    // The same object while nothing moved, so that nothing is painted anew.
    Diagram shown = drawing.equals(look.drawing()) ? look.drawing() : drawing;
    return new TfTreeViewState(wanted, forest.size() == 0 ? NOTHING : LIVE, rows, shown,
        Notices.of(forest, all, frames.refusals(), ages),
        Optional.empty(), forest.size(), forest.roots().size());
  }

  private Optional<FrameRow> row(FrameId frame) {
    return all.stream().filter(row -> row.id().equals(frame)).findFirst();
  }

  /** What the last tick prepared. */
  public TfTreeViewState look() {
    return look;
  }

  /** All frames that are known now. */
  public List<FrameId> frames() {
    return frames.all();
  }

  /** What is asked for now. */
  public Ask ask() {
    return ask;
  }

  /** Asks for something else. */
  public void ask(Ask next) {
    ask = next;
  }

  /** How wide letters are where it is painted. */
  public void widths(TextWidths exact) {
    widths = exact;
  }
}
