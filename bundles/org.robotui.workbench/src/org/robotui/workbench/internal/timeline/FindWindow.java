package org.robotui.workbench.internal.timeline;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RowTable;

/**
 * A window beside the views in which somebody searches the recordings: a condition, and the times at which it held. It
 * stays open while the timeline is moved. Display thread only.
 */
final class FindWindow {
  private static final int WIDTH = 760;
  private static final int HEIGHT = 420;
  private static final String EXAMPLE = "battery charge < 0.2 for 5 s";
  private static final List<String> EXAMPLES =
      List.of(EXAMPLE, "age(scan) > 0.5", "scan stale for 2 s", "delay(odom) > 0.1",
          "battery status changes", "diagnostics motor >= WARNING", "diagnostics changes", "log >= ERROR");

  private final Theme theme;
  private final BarState bar;
  private final LiveTimeline live;
  private final EventSearch search;
  private final BesideShell frame;
  private final Shell shell;
  private final Text condition;
  private final QuietButton go;
  private final QuietButton examples;
  private final NoticeLine said;
  private final RowTable<FoundRow> table;
  private final QuietButton keep;

  /** Over the window of a control; opened by {@link #open}. */
  FindWindow(Control over, Theme theme, BarState bar, LiveTimeline live, EventSearch search) {
    this.theme = theme;
    this.bar = bar;
    this.live = live;
    this.search = search;
    frame = new BesideShell(over, theme, "Find in Recordings");
    shell = frame.shell();
    Composite head = frame.row(3);
    condition = frame.field(head, EXAMPLE, this::start);
    condition.setText(search.state().condition());
    condition.selectAll();
    go = new QuietButton(head, theme, this::press).text("Find");
    examples =
        new QuietButton(head, theme, this::examples).icon(Icon.MORE).hint("Examples; conditions are those of alerts");
    said = frame.notice();
    table = table();
    Composite foot = frame.row(2);
    keep = new QuietButton(foot, theme, this::keepAll).icon(Icon.BOOKMARK).text("Keep All as Bookmarks")
        .hint("Keep all that was found as bookmarks, with what was seen as the note");
    new QuietButton(foot, theme, this::forget).text("Clear")
        .hint("Forget what was found, and take the marks from the timeline");
    Runnable found = search.onChange(this::show);
    Runnable moved = live.onChange(this::show);
    shell.addListener(SWT.Dispose, e -> {
      found.run();
      moved.run();
    });
    show();
  }

  private RowTable<FoundRow> table() {
    List<Column<FoundRow>> columns = List.of(
        Column.<FoundRow>figures("Time", row -> TimeWords.seconds(row.range().start() - bar.all().start())).width(110),
        Column.<FoundRow>figures("For", FoundRow::length).width(170),
        Column.<FoundRow>words("What", FoundRow::words).weight(1),
        Column.<FoundRow>words("Recording", FoundRow::file).role(Role.DIM).width(170));
    RowTable<FoundRow> made = new RowTable<>(shell, theme, columns, FoundRow::number);
    frame.fill(made.control());
    made.list().named("What was found").several().onSelect(this::selected).onOpen(row -> seek(row))
        .menu(this::menu);
    return made;
  }

  /** Shows it, or brings it to the front. */
  void open() {
    frame.open(WIDTH, HEIGHT, false);
    focus();
  }

  /** Takes the keys. */
  void focus() {
    shell.setActive();
    condition.setFocus();
  }

  boolean isClosed() {
    return shell.isDisposed();
  }

  void close() {
    shell.dispose();
  }

  /** For tests. */
  Shell shell() {
    return shell;
  }

  private void examples() {
    PopupMenu menu = new PopupMenu(examples);
    EXAMPLES.forEach(each -> menu.push(each, () -> {
      condition.setText(each);
      condition.setFocus();
    }));
    menu.openBelow(examples);
  }

  private void press() {
    if (search.state().running()) {
      search.stop();
    } else {
      start();
    }
  }

  private void start() {
    String words = condition.getText().strip();
    if (words.isEmpty()) {
      return;
    }
    Optional<String> fault = search.fault(words);
    if (fault.isPresent()) {
      said.show(Health.BAD, fault.get());
    } else {
      search.start(words);
    }
  }

  private void forget() {
    search.clear();
    condition.setFocus();
  }

  private void show() {
    if (shell.isDisposed()) {
      return;
    }
    FoundEvents now = search.state();
    go.text(now.running() ? "Stop" : "Find");
    said.show(now.health(), now.words());
    table.show(bar.found());
    keep.setEnabled(!bar.found().isEmpty());
  }

  private void selected(List<FoundRow> rows) {
    rows.stream().findFirst().filter(row -> rows.size() == 1).ifPresent(this::seek);
  }

  private void seek(FoundRow row) {
    live.timeline().ifPresent(timeline -> timeline.seek(row.range().start()));
  }

  private void menu(PopupMenu menu, List<FoundRow> rows) {
    live.timeline().filter(timeline -> !rows.isEmpty()).ifPresent(timeline -> {
      menu.push("Keep as Bookmark" + (rows.size() == 1 ? "" : "s"),
          () -> rows.forEach(row -> timeline.mark(row.bookmark())));
      menu.push("Play This Only", rows.size() == 1 && rows.getFirst().range().length() > 0,
          () -> timeline.range(Optional.of(rows.getFirst().range())));
    });
  }

  private void keepAll() {
    live.timeline().ifPresent(timeline -> bar.found().forEach(row -> timeline.mark(row.bookmark())));
  }
}
