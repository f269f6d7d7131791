package org.robotui.workbench.internal.rcp;

import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.timeline.BarState;
import org.robotui.workbench.internal.timeline.TimelineBar;

/** Puts the bar of recordings below the views of a window, where it has no height while no recording is open. */
final class TimelineBelow {
  private TimelineBelow() {}

  /** Answers the place of the views. */
  static Composite add(Composite whole, WorkbenchSession session) {
    Composite both = new Composite(whole, SWT.NONE);
    GridLayout layout = new GridLayout(1, false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    layout.verticalSpacing = 0;
    both.setLayout(layout);
    Composite views = place(both, SWT.FILL, true);
    Composite time = place(both, SWT.BOTTOM, false);
    BarState bar = new BarState(session.host().pointed());
    new Rebuilt<>(time, session, (parent, theme) -> new TimelineBar(parent, theme, session.timeline(),
        session.search(), session.compare(), session.analysis(), bar),
        control -> {});
    return views;
  }

  private static Composite place(Composite both, int vertical, boolean grab) {
    Composite place = new Composite(both, SWT.NONE);
    place.setLayout(new FillLayout());
    place.setLayoutData(new GridData(SWT.FILL, vertical, true, grab));
    return place;
  }
}
