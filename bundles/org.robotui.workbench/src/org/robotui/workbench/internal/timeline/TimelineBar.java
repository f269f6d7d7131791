package org.robotui.workbench.internal.timeline;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * The bar of recordings: the strip of their time, buttons below it, and above it, where the user wants them, the
 * recordings with their topics. Without recordings it has no height. Display thread only.
 */
public final class TimelineBar extends Composite {
  private final BarState bar;
  private final LiveTimeline live;
  private final EventSearch search;
  private final RunCompare compare;
  private final Theme theme;
  private final LaneList lanes;
  private final TimeStrip strip;
  private final TransportRow transport;
  private Optional<FindWindow> find = Optional.empty();
  private Optional<CompareWindow> comparing = Optional.empty();
  private int height = -1;

  /**
   * A bar.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param live the timeline
   * @param search finds when something was so
   * @param compare says how far two recordings are apart
   * @param analysis estimates offsets and writes reports
   * @param bar how the user looks at it; outlives the control
   */
  public TimelineBar(Composite parent, Theme theme, LiveTimeline live, EventSearch search, RunCompare compare,
      TrackAnalysis analysis, BarState bar) {
    super(parent, SWT.NONE);
    this.live = live;
    this.search = search;
    this.compare = compare;
    this.theme = theme;
    this.bar = bar;
    setBackground(theme.color(Role.PANEL));
    addPaintListener(e -> {
      e.gc.setForeground(theme.color(Role.LINE));
      e.gc.drawLine(0, 0, getSize().x, 0);
    });
    GridLayout layout = new GridLayout(1, false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    layout.marginTop = 1; // the line between it and the views
    layout.verticalSpacing = 0;
    setLayout(layout);
    NewestSeek seek = new NewestSeek(getDisplay()::asyncExec, time -> live.timeline().ifPresent(t -> t.seek(time)));
    lanes = new LaneList(this, theme, bar, live, seek, this::show, analysis,
        (track, topic) -> compare().propose(track, topic));
    strip = new TimeStrip(this, theme, bar, live, seek, this::show);
    transport = new TransportRow(this, theme, bar, live, this::expand, this::find, this::compare);
    lanes.canvas().setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
    GridData time = new GridData(SWT.FILL, SWT.TOP, true, false);
    time.heightHint = StripPaint.HEIGHT;
    strip.canvas().setLayoutData(time);
    transport.control().setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
    setTabList(new Control[]{strip.canvas(), transport.control(), lanes.canvas()});
    // Before what it found is asked for: whoever listens later sees what this bar has taken up.
    Runnable ended = search.onChange(this::show);
    Runnable asked = search.onAsk(this::asked);
    Runnable end = live.onChange(this::show);
    Display display = getDisplay();
    Runnable pointed = bar.pointed().listen(() -> display.asyncExec(this::pointed));
    addListener(SWT.Dispose, e -> {
      pointed.run();
      bar.leave();
      ended.run();
      end.run();
      asked.run();
      find.ifPresent(FindWindow::close);
      comparing.ifPresent(CompareWindow::close);
    });
    show();
  }

  @Override
  public Point computeSize(int widthHint, int heightHint, boolean changed) {
    Point size = super.computeSize(widthHint, heightHint, changed);
    return bar.tracks().isEmpty() ? new Point(size.x, 0) : size;
  }

  @Override
  public boolean setFocus() {
    return strip.canvas().setFocus();
  }

  /** Of all windows that which the user works with opens it. */
  private void asked() {
    if (!bar.tracks().isEmpty() && getDisplay().getActiveShell() == getShell()) {
      find();
    }
  }

  /** Opens the window in which recordings are searched. */
  public void find() {
    if (find.filter(window -> !window.isClosed()).isEmpty()) {
      FindWindow window = new FindWindow(this, theme, bar, live, search);
      find = Optional.of(window);
      window.open();
    } else {
      find.ifPresent(FindWindow::focus);
    }
  }

  /** Opens the window in which two recordings are compared. */
  CompareWindow compare() {
    Optional<CompareWindow> open = comparing.filter(window -> !window.isClosed());
    open.ifPresent(CompareWindow::focus);
    CompareWindow shown = open.orElseGet(() -> {
      CompareWindow made = new CompareWindow(this, theme, live, compare, bar.pointed());
      made.open();
      return made;
    });
    comparing = Optional.of(shown);
    return shown;
  }

  private void expand() {
    bar.expand(!bar.isExpanded());
    show();
  }

  /** Takes up how things stand, and has it painted. */
  private void show() {
    if (isDisposed()) {
      return;
    }
    bar.take(live.state(), live.tracks());
    bar.take(search.state().events(), live.tracks());
    lay();
    transport.show();
    strip.canvas().requestPaint();
    if (bar.isExpanded()) {
      lanes.canvas().requestPaint();
    }
  }

  /** The user points at another time in a view. */
  private void pointed() {
    if (!isDisposed() && !bar.tracks().isEmpty()) {
      strip.canvas().requestPaint();
      if (bar.isExpanded()) {
        lanes.canvas().requestPaint();
      }
    }
  }

  /** Only where its height changes: laying out a window takes long. */
  private void lay() {
    GridData rows = (GridData) lanes.canvas().getLayoutData();
    rows.exclude = !bar.isExpanded();
    rows.heightHint = lanes.height();
    int wanted = bar.tracks().isEmpty() ? 0 : bar.isExpanded() ? 1 + rows.heightHint : 1;
    if (wanted != height) {
      height = wanted;
      lanes.canvas().setVisible(bar.isExpanded());
      setVisible(height > 0);
      requestLayout();
      getParent().requestLayout();
    }
  }
}
