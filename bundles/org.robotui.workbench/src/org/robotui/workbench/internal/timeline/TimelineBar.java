package org.robotui.workbench.internal.timeline;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * The bar of recordings: the strip of their time, buttons below it, and above it, where the user wants them, the
 * recordings with their topics. Without recordings it has no height. Display thread only.
 */
public final class TimelineBar extends Composite {
  private final BarState bar;
  private final LiveTimeline live;
  private final LaneList lanes;
  private final TimeStrip strip;
  private final TransportRow transport;
  private int height = -1;

  /**
   * A bar.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param live the timeline
   * @param bar how the user looks at it; outlives the control
   */
  public TimelineBar(Composite parent, Theme theme, LiveTimeline live, BarState bar) {
    super(parent, SWT.NONE);
    this.live = live;
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
    lanes = new LaneList(this, theme, bar, live, seek, this::show);
    strip = new TimeStrip(this, theme, bar, live, seek, this::show);
    transport = new TransportRow(this, theme, bar, live, this::expand);
    lanes.canvas().setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
    GridData time = new GridData(SWT.FILL, SWT.TOP, true, false);
    time.heightHint = StripPaint.HEIGHT;
    strip.canvas().setLayoutData(time);
    transport.control().setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
    setTabList(new Control[]{strip.canvas(), transport.control(), lanes.canvas()});
    Runnable end = live.onChange(this::show);
    addListener(SWT.Dispose, e -> end.run());
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
    lay();
    transport.show();
    strip.canvas().requestPaint();
    if (bar.isExpanded()) {
      lanes.canvas().requestPaint();
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
