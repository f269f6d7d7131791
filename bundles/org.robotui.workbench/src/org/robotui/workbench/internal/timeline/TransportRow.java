package org.robotui.workbench.internal.timeline;

import java.time.ZoneId;
import java.util.List;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Text;
import org.robotui.api.replay.Timeline;
import org.robotui.api.replay.TimelineState;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.PlainLabel;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;

/** The buttons below the strip, and where the time is. Display thread only. */
final class TransportRow {
  /** The key of SWT for a style of GTK: times that can be selected look like others. */
  private static final String LOOK = "org.eclipse.swt.internal.gtk.css";
  private static final String LAGGING = "Messages cannot be read or shown as fast as the speed says";

  private final Composite row;
  private final Theme theme;
  private final BarState bar;
  private final LiveTimeline live;
  private final QuietButton expand;
  private final QuietButton play;
  private final QuietButton speed;
  private final QuietButton loop;
  private final Text local;
  private final Text relative;
  private final PlainLabel lagging;
  private final QuietButton problems;

  /**
   * A row for a bar; {@code expanded} is run when recordings are to be shown, or not any more, {@code find} when they
   * are to be searched.
   */
  TransportRow(Composite parent, Theme theme, BarState bar, LiveTimeline live, Runnable expanded, Runnable find,
      Runnable compare) {
    this.theme = theme;
    this.bar = bar;
    this.live = live;
    row = new Composite(parent, SWT.NONE);
    row.setBackground(theme.color(Role.PANEL));
    expand = button(Icon.CLOSED, "Show the recordings with their topics", t -> expanded.run());
    button(Icon.STEP_BACK, "Step back by one message", t -> live.step(false));
    play = button(Icon.PLAY, "Play", t -> new TimelineMoves(t).toggle());
    button(Icon.STEP_FORWARD, "Step on by one message", t -> live.step(true));
    speed = button("Speed", this::speeds);
    loop = button(Icon.LOOP, "Begin again at the end of what is played", t -> t.loop(!bar.state().looping()));
    QuietButton[] marks = new QuietButton[1];
    marks[0] = button(Icon.BOOKMARK, "Bookmarks",
        t -> new BookmarkMenu(marks[0], bar, t).all().openBelow(marks[0]));
    button(Icon.FIND, "Find when something was so", t -> find.run());
    button(Icon.LAYERS, "Compare two recordings", t -> compare.run());
    local = time("0000-00-00 00:00:00.000", "Time of the position, on this machine's clock");
    relative = time("00000.000 s", "Seconds after the start of the recordings");
    lagging = new PlainLabel(row, SWT.NONE, theme, Face.SMALL, Role.WARNING);
    lagging.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    problems = new QuietButton(row, theme, this::tellProblems);
    problems.setLayoutData(new GridData());
    lay();
  }

  private void lay() {
    GridLayout layout = new GridLayout(row.getChildren().length, false);
    layout.marginWidth = Theme.STEP;
    layout.marginHeight = 0;
    layout.horizontalSpacing = Theme.STEP;
    row.setLayout(layout);
  }

  Composite control() {
    return row;
  }

  private QuietButton button(Icon icon, String hint, Consumer<Timeline> pressed) {
    return new QuietButton(row, theme, () -> live.timeline().ifPresent(pressed)).icon(icon).hint(hint);
  }

  private QuietButton button(String hint, Runnable pressed) {
    QuietButton button = new QuietButton(row, theme, pressed).hint(hint);
    GC gc = new GC(button);
    int width = gc.textExtent("0.05\u00d7").x + 2 * Theme.EDGE;
    gc.dispose();
    GridData data = new GridData();
    data.widthHint = width;
    button.setLayoutData(data);
    return button;
  }

  /** As wide as its longest value, so that nothing moves while time goes on. */
  private Text time(String longest, String name) {
    Text text = new Text(row, SWT.SINGLE | SWT.READ_ONLY);
    text.setFont(theme.font(Face.FIGURES));
    text.setBackground(theme.color(Role.PANEL));
    text.setForeground(theme.color(Role.TEXT));
    text.setData(LOOK, "entry { border-color: transparent; box-shadow: none; background: none; min-height: 0; "
        + "padding: 0 4px; }");
    text.setToolTipText(name);
    GC gc = new GC(text);
    GridData data = new GridData(SWT.BEGINNING, SWT.CENTER, false, false);
    data.widthHint = gc.textExtent(longest).x + 4 * Theme.STEP;
    gc.dispose();
    text.setLayoutData(data);
    return text;
  }

  /** Shows how things stand. */
  void show() {
    TimelineState now = bar.state();
    expand.icon(bar.isExpanded() ? Icon.OPEN : Icon.CLOSED)
        .hint(bar.isExpanded() ? "Hide the recordings" : "Show the recordings with their topics");
    play.icon(now.playing() ? Icon.PAUSE : Icon.PLAY).hint(now.playing() ? "Pause" : "Play");
    speed.text(TimeWords.speed(now.speed()));
    loop.checked(now.looping());
    write(local, TimeWords.local(now.position(), ZoneId.systemDefault()));
    write(relative, TimeWords.seconds(now.position() - bar.all().start()));
    lagging.setText(now.lagging() ? "lagging: slower than " + TimeWords.speed(now.speed()) : "");
    lagging.setToolTipText(now.lagging() ? LAGGING : null);
    problems();
  }

  /** What is being selected stays until the user has copied it. */
  private static void write(Text text, String words) {
    boolean selected = text.isFocusControl() && text.getSelectionCount() > 0;
    if (!selected && !text.getText().equals(words)) {
      text.setText(words);
    }
  }

  private void problems() {
    int count = bar.problems().size();
    boolean shown = count > 0;
    problems.text(count == 1 ? "\u26a0 1 problem" : "\u26a0 " + count + " problems")
        .hint(String.join("\n", bar.problems()));
    GridData data = (GridData) problems.getLayoutData();
    if (data.exclude == shown) {
      data.exclude = !shown;
      problems.setVisible(shown);
      row.layout(true);
    }
  }

  private void tellProblems() {
    PopupMenu menu = new PopupMenu(problems);
    bar.problems().forEach(problem -> menu.push(problem, () -> Clipboards.copy(problem)));
    menu.openBelow(problems);
  }

  private void speeds() {
    PopupMenu menu = new PopupMenu(speed);
    List<Double> speeds = TimelineMoves.SPEEDS;
    live.timeline().ifPresent(t -> speeds
        .forEach(s -> menu.radio(TimeWords.speed(s), bar.state().speed() == s, () -> t.speed(s))));
    menu.openBelow(speed);
  }
}
