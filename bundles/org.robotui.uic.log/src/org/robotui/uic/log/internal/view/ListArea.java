package org.robotui.uic.log.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.port.InputState;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RowList;
import org.robotui.uic.log.internal.model.LogLine;
import org.robotui.uic.log.internal.model.Notice;
import org.robotui.uic.log.internal.model.Shown;
import org.robotui.uic.log.internal.model.Wording;

/** The list, and the pill over it that leads back to the newest. Display thread. */
final class ListArea {
  private static final int ABOVE_EDGE = 14;

  private final Composite root;
  private final LineLook look;
  private final RowList<LogLine> list;
  private final QuietButton pill;
  private final Runnable toNewest;
  private long seenId = Long.MAX_VALUE;
  private Shown shown = Shown.NOTHING;

  ListArea(Composite parent, Theme theme, Wording wording, Runnable resume) {
    root = new Composite(parent, SWT.NONE);
    root.setBackground(theme.color(Role.PANEL));
    look = new LineLook(theme, wording);
    toNewest = resume;
    pill = new QuietButton(root, theme, this::jump).fill(Role.ACCENT).hint("Go to the newest entry and follow");
    pill.setVisible(false);
    list = new RowList<>(root, theme, look).named("Log").several().follow(this::followed);
    root.addListener(SWT.Resize, e -> arrange());
  }

  Control control() {
    return root;
  }

  RowList<LogLine> list() {
    return list;
  }

  List<LogLine> selected() {
    return list.selected();
  }

  void show(Frame frame) {
    boolean refiltered = !frame.shown().filter().equals(shown.filter());
    shown = frame.shown();
    look.search(frame.filter().search());
    list.state(shown.kept() > 0 ? new InputState.Live(0, 0) : frame.state());
    Optional<Notice> notice = Notice.inPlace(shown, frame.state());
    notice.ifPresentOrElse(n -> list.message(n.health(), n.title(), n.sentence()), list::noMessage);
    list.show(shown.lines());
    if (refiltered && !list.following()) {
      keepInSight();
    }
    tellNew(frame.paused());
  }

  void jump() {
    toNewest.run();
    list.following(true);
    list.selectNone();
  }

  /** A found entry stays selected when the search ends: then its neighbours are seen. */
  private void keepInSight() {
    List<LogLine> selected = list.selected();
    if (selected.size() == 1) {
      list.select(selected.getFirst().id());
    }
  }

  private void followed(boolean on) {
    seenId = on || shown.lines().isEmpty() ? Long.MAX_VALUE : shown.lines().getLast().id();
    tellNew(false);
  }

  private void tellNew(boolean paused) {
    boolean wanted = paused || !list.following() && !shown.lines().isEmpty();
    if (wanted) {
      String words =
          paused ? "Paused, resume" + (shown.held() == 0 ? "" : ", " + shown.held() + " new") : words(newLines());
      pill.text(words);
      arrange();
    }
    if (pill.getVisible() != wanted) {
      pill.setVisible(wanted);
      pill.moveAbove(null);
    }
  }

  private static String words(long count) {
    return count == 0 ? "To the newest" : "To the newest, " + count + " new";
  }

  private long newLines() {
    return seenId == Long.MAX_VALUE ? 0 : shown.lines().size() - 1L - shown.indexOf(seenId);
  }

  private void arrange() {
    Rectangle area = root.getClientArea();
    list.control().setBounds(area);
    Point size = pill.computeSize(SWT.DEFAULT, SWT.DEFAULT);
    pill.setBounds((area.width - size.x) / 2, Math.max(0, area.height - size.y - ABOVE_EDGE), size.x, size.y);
  }
}
