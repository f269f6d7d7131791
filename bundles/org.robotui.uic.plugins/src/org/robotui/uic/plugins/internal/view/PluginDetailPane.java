package org.robotui.uic.plugins.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Text;
import org.robotui.api.port.PluginRequest.Verb;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.QuietButton;
import org.robotui.uic.plugins.internal.model.PluginDetail;
import org.robotui.uic.plugins.internal.model.PluginLine;
import org.robotui.uic.plugins.internal.model.PluginNotice;
import org.robotui.uic.plugins.internal.model.Verbs;

/** The selected plugin or thread: verbs, errors as a whole, and the evidence of its time. Display thread. */
final class PluginDetailPane {
  private static final int MOST_LINES = 8;
  private static final int ROOM_BESIDE = 760;
  private static final int ROOM_BELOW = 220;

  private final Composite root;
  private final DetailHead head;
  private final NoticeLine status;
  private final NoticeLine told;
  private final Composite problemBox;
  private final Text problem;
  private final CommandLine command;
  private final Composite plots;
  private final HistogramView wakeUp;
  private final HistogramView busy;
  private final NoticeLine counts;
  private final Composite figures;
  private final NoticeLine since;

  PluginDetailPane(Composite parent, Theme theme, Verbs verbs, Runnable asked, Runnable resetPressed) {
    root = Boxes.panel(parent, theme, 1);
    head = new DetailHead(root, theme, verbs, asked);
    status = new NoticeLine(root, theme, Face.BODY);
    told = new NoticeLine(root, theme, Face.BODY);
    problemBox = Boxes.inset(root, theme, 1, Theme.EDGE, Theme.STEP / 2);
    problemBox.setLayoutData(Boxes.line());
    problem = problem(theme);
    command = new CommandLine(root, theme, (plugin, words) -> {
      verbs.ask(plugin, Verb.COMMAND, words);
      asked.run();
    });
    plots = Boxes.panel(root, theme, 1);
    plots.setLayoutData(Boxes.fill());
    wakeUp = new HistogramView(plots, theme, "Wake-up latency");
    wakeUp.control().setLayoutData(Boxes.fill());
    busy = new HistogramView(plots, theme, "Busy time");
    busy.control().setLayoutData(Boxes.fill());
    counts = new NoticeLine(root, theme, Face.SMALL);
    figures = Boxes.bar(root, theme, 2);
    ((GridLayout) figures.getLayout()).marginWidth = 0;
    ((GridLayout) figures.getLayout()).marginHeight = 0;
    since = new NoticeLine(figures, theme, Face.SMALL);
    QuietButton reset =
        new QuietButton(figures, theme, resetPressed).text("Reset").hint("Has all figures count from now on");
    reset.setLayoutData(Boxes.middle());
    plots.addListener(SWT.Resize, e -> arrange());
  }

  Control control() {
    return root;
  }

  DetailHead head() {
    return head;
  }

  CommandLine command() {
    return command;
  }

  Text problem() {
    return problem;
  }

  void show(PluginDetail detail) {
    head.show(detail);
    status.show(detail.health(), detail.status());
    boolean changed = command.show(detail.plugin().map(PluginLine::name), detail.usable());
    changed |= tell(detail);
    changed |= problem(detail.problem());
    boolean timed = detail.drives().isEmpty();
    changed |= Boxes.seen(plots, timed) | Boxes.seen(counts.control(), timed) | Boxes.seen(figures, timed);
    wakeUp.show(Optional.of(detail.loop().wakeUp()), 0, detail.isStale());
    busy.show(Optional.of(detail.line().busy()), detail.line().period(), detail.isStale());
    counts.show(detail.countsHealth(), detail.counts());
    since.show(Health.NONE, detail.from());
    if (changed) {
      root.layout();
    }
  }

  private boolean tell(PluginDetail detail) {
    PluginNotice said =
        detail.isAskable() && detail.told().health() != Health.BAD ? detail.told() : PluginNotice.NOTHING;
    told.show(said.health(), said.text());
    return Boxes.seen(told.control(), !said.text().isEmpty());
  }

  /** Shown whole, to be read and copied; what was selected in it stays so while it is the same. */
  private boolean problem(String text) {
    if (!problem.getText().equals(text)) {
      problem.setText(text);
      GridData data = (GridData) problem.getLayoutData();
      int lines = (int) Math.clamp(text.lines().count() + 1, 3, MOST_LINES);
      data.heightHint = lines * problem.getLineHeight();
      Boxes.seen(problemBox, !text.isEmpty());
      return true;
    }
    return Boxes.seen(problemBox, !text.isEmpty());
  }

  private Text problem(Theme theme) {
    Text text = new Text(problemBox, SWT.MULTI | SWT.READ_ONLY | SWT.WRAP | SWT.V_SCROLL);
    text.setFont(theme.font(Face.FIGURES));
    text.setBackground(theme.color(Role.GROUND));
    text.setForeground(theme.color(Role.BAD));
    GridData data = new GridData(SWT.FILL, SWT.TOP, true, false);
    data.widthHint = 0;
    text.setLayoutData(data);
    Boxes.seen(problemBox, false);
    return text;
  }

  /** The plots stand beside each other where that is wide enough, or too low for both. */
  private void arrange() {
    Rectangle room = plots.getClientArea();
    int columns = room.width >= ROOM_BESIDE || room.height < ROOM_BELOW ? 2 : 1;
    GridLayout layout = (GridLayout) plots.getLayout();
    if (layout.numColumns != columns) {
      layout.numColumns = columns;
      plots.layout();
    }
  }
}
