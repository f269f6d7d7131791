package org.robotui.workbench.internal.pane;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.SashForm;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.host.Host;
import org.robotui.api.host.SettingsGroup;
import org.robotui.api.host.SettingsOutcome;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.FormProblem;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RowTable;
import org.robotui.ui.control.SettingsForm;
import org.robotui.workbench.internal.model.WrittenRow;

/**
 * What the configuration files say of robots, and changes of that in the files. Files are read and written in the
 * background. Display thread only.
 */
public final class WrittenPane extends Composite {
  private static final int LIST_SHARE = 2;
  private static final int FORM_SHARE = 3;

  private final Host host;
  private final Executor background;
  private final FilterField filter;
  private final RowTable<WrittenRow> table;
  private final SettingsForm form;
  private final NoticeLine place;
  private final NoticeLine notice;
  private final QuietButton write;
  private final QuietButton back;
  private List<SettingsGroup> groups = List.of();
  private Optional<WrittenRow> shown = Optional.empty();

  /**
   * Makes it, and has the files read.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param host knows the files
   * @param background reads and writes them
   * @param ruic whose settings are shown first, empty for the first; asked once the files have been read
   */
  public WrittenPane(Composite parent, Theme theme, Host host, Executor background, Supplier<String> ruic) {
    super(parent, SWT.NONE);
    this.host = host;
    this.background = background;
    setBackground(theme.color(Role.PANEL));
    setLayout(Boxes.grid(1));
    filter = new FilterField(this, theme, "Search robots and settings", words -> showRows());
    filter.setLayoutData(Boxes.line());
    SashForm split = Boxes.split(this, theme, SWT.HORIZONTAL);
    split.setLayoutData(Boxes.fill());
    table = new RowTable<>(split, theme, columns(), WrittenRow::key);
    table.list().named("Robots and what can be set of them").onSelect(rows -> select(rows.stream().findFirst()));
    table.list().control().addListener(SWT.Traverse, e -> e.doit |= e.detail == SWT.TRAVERSE_ESCAPE);
    filter.onDown(() -> table.list().control().setFocus());
    Composite right = Boxes.panel(split, theme, 1);
    place = new NoticeLine(right, theme, Face.BODY_STRONG);
    form = new SettingsForm(right, theme, host::wrong);
    form.control().setLayoutData(Boxes.fill());
    form.onChange(this::edited);
    split.setWeights(LIST_SHARE, FORM_SHARE);
    notice = new NoticeLine(this, theme, Face.BODY);
    Composite bar = Boxes.bar(this, theme, 2);
    write = new QuietButton(bar, theme, this::write).text("Write")
        .hint("Writes what was changed into the file; all else in it stays as it is");
    back = new QuietButton(bar, theme, this::asFile).text("As the File Says")
        .hint("Reads the file again and forgets what was typed");
    edited();
    read(g -> !g.ruic().isEmpty() && g.ruic().equals(ruic.get()), "");
  }

  @Override
  public boolean setFocus() {
    return !filter.isDisposed() && filter.setFocus(); // a button that goes hands its focus on
  }

  private static List<Column<WrittenRow>> columns() {
    return List.of(
        Column.words("Robot", WrittenRow::what).weight(3).hint(r -> r.group().ruic() + " " + r.what().strip()),
        Column.words("", WrittenRow::kind).weight(2).role(Role.DIM));
  }

  /** Reads the files, and shows the first group that is wanted, or the first of all. */
  private void read(Predicate<SettingsGroup> wanted, String said) {
    background.execute(() -> {
      List<SettingsGroup> now = host.settings().groups();
      later(() -> {
        groups = now;
        showRows();
        Optional<WrittenRow> first = table.list().rows().stream().filter(r -> wanted.test(r.group())).findFirst()
            .or(() -> table.list().rows().stream().findFirst());
        first.ifPresent(row -> table.list().select(row.key()));
        select(first);
        if (!said.isEmpty()) {
          notice.show(Health.OK, said);
        }
      });
    });
  }

  private void showRows() {
    List<WrittenRow> rows = WrittenRow.of(groups, filter.words());
    table.show(rows);
    if (rows.isEmpty()) {
      table.list().message(Health.NONE, "Nothing to set",
          groups.isEmpty() ? "No configuration without an error is open." : "Search by other words.");
    } else {
      table.list().noMessage();
    }
    table.highlight(filter.words().strip());
  }

  private void select(Optional<WrittenRow> row) {
    if (row.isPresent() && !row.equals(shown)) {
      shown = row;
      form.show(row.get().group().schema(), row.get().group().values());
      place.show(Health.NONE, row.get().heading());
    }
    edited();
  }

  private void edited() {
    boolean fine = form.problems().isEmpty();
    boolean changed = shown.filter(r -> !r.group().changed(form.values()).isEmpty()).isPresent();
    write.setEnabled(changed && fine);
    back.setEnabled(changed || !fine);
    String words = shown.map(r -> !fine ? first(form.problems().getFirst())
        : changed ? "Write puts it into " + r.group().file().getFileName() + ". " + r.holds()
            : r.group().file().toString())
        .orElse("Choose what to change.");
    notice.show(fine ? Health.NONE : Health.BAD, words);
  }

  /** Within a group, it is said where. */
  private static String first(FormProblem problem) {
    return problem.path().contains("/") ? problem.path() + ": " + problem.sentence() : problem.sentence();
  }

  private void asFile() {
    Optional<Object> key = shown.map(WrittenRow::key);
    shown = Optional.empty();
    read(g -> key.filter(List.of(g.file(), g.path())::equals).isPresent(), "");
  }

  private void write() {
    WrittenRow row = shown.orElseThrow();
    Map<String, Object> values = form.values();
    write.setEnabled(false);
    notice.show(Health.WAITING, "Writing " + row.group().file());
    background.execute(() -> {
      SettingsOutcome outcome = host.settings().write(row.group(), values);
      later(() -> wrote(row, outcome));
    });
  }

  private void wrote(WrittenRow row, SettingsOutcome outcome) {
    switch (outcome) {
      case SettingsOutcome.Done done -> {
        shown = Optional.empty();
        read(g -> List.of(g.file(), g.path()).equals(row.key()),
            String.join(", ", done.changed()) + " written to " + row.place() + ". " + row.holds());
      }
      case SettingsOutcome.Refused refused -> {
        write.setEnabled(true);
        notice.show(Health.BAD, refused.reason());
      }
    }
  }

  private void later(Runnable task) {
    if (!isDisposed()) {
      getDisplay().asyncExec(() -> {
        if (!isDisposed()) {
          task.run();
        }
      });
    }
  }
}
