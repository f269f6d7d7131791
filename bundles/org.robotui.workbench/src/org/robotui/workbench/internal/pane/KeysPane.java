package org.robotui.workbench.internal.pane;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.eclipse.jface.bindings.keys.KeySequence;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.ViewKey;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RowTable;
import org.robotui.workbench.internal.keys.KeyRules;
import org.robotui.workbench.internal.keys.KeyStore;
import org.robotui.workbench.internal.keys.KeyWords;
import org.robotui.workbench.internal.keys.KeyedCommand;
import org.robotui.workbench.internal.keys.Keymap;
import org.robotui.workbench.internal.model.KeyRow;

/** All commands with their keys, which can be changed here. What is changed holds at once. Display thread only. */
public final class KeysPane extends Composite {
  private final KeyStore store;
  private final Supplier<Map<String, List<ViewKey>>> views;
  private final FilterField filter;
  private final RowTable<KeyRow> table;
  private final NoticeLine notice;
  private final KeyRecorder recorder;
  private final List<QuietButton> buttons = new ArrayList<>();
  private final QuietButton takeOver;
  private Runnable taking = () -> {};

  /**
   * Makes the list.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param store the keys
   * @param views the keys of the views that are open, by the title of the view
   * @param recorder listens for a key
   */
  public KeysPane(Composite parent, Theme theme, KeyStore store, Supplier<Map<String, List<ViewKey>>> views,
      KeyRecorder recorder) {
    super(parent, SWT.NONE);
    this.store = store;
    this.views = views;
    this.recorder = recorder;
    setBackground(theme.color(Role.PANEL));
    setLayout(Boxes.grid(1));
    filter = new FilterField(this, theme, "Search commands and keys", words -> show());
    filter.setLayoutData(Boxes.line());
    filter.onDown(this::toFirst).onEnter(this::toFirst);
    table = new RowTable<>(this, theme, columns(), (KeyRow row) -> row.command().id());
    table.list().control()
        .addListener(SWT.Traverse, e -> e.doit |= e.detail == SWT.TRAVERSE_ESCAPE); // closes the dialog, as everywhere
                                                                                    // in it
    table.control().setLayoutData(Boxes.fill());
    table.list().named("Commands and their keys").onOpen(row -> record(row, false)).onSelect(rows -> selected());
    notice = new NoticeLine(this, theme, Face.BODY);
    Composite bar = Boxes.bar(this, theme, 6);
    button(bar, theme, "Set Key", "Gives the command another key in place of those that it has",
        () -> withSelected(row -> record(row, false)));
    button(bar, theme, "Add Key", "Gives the command one more key", () -> withSelected(row -> record(row, true)));
    button(bar, theme, "Remove Keys", "The command has no key any more",
        () -> withSelected(row -> change(row, store.now().with(row.command(), List.of()))));
    button(bar, theme, "Usual Keys", "Gives the command the keys that it usually has",
        () -> withSelected(row -> change(row, store.now().reset(row.command()))));
    button(bar, theme, "All Usual Keys", "Gives all commands the keys that they usually have", this::resetAll);
    takeOver = button(bar, theme, "Take It Over", "Gives the key to this command and takes it from the other",
        () -> taking.run());
    Runnable end = store.onChange(this::show);
    addListener(SWT.Dispose, e -> end.run());
    addListener(SWT.Dispose, e -> recorder.end());
    show();
    selected();
  }

  /** From the field to the first command that was found. */
  private void toFirst() {
    table.list().rows().stream().findFirst().ifPresent(row -> {
      table.list().control().setFocus();
      select(row.command().id());
    });
  }

  /** Chooses a command by its id. */
  void select(String id) {
    table.list().select(id);
    selected();
  }

  @Override
  public boolean setFocus() {
    return !filter.isDisposed() && filter.setFocus(); // a button that goes hands its focus on
  }

  private static List<Column<KeyRow>> columns() {
    return List.of(Column.<KeyRow>words("Command", row -> row.command().name()).weight(3)
        .hint(row -> row.command().help()).dot(KeyRow::health),
        Column.<KeyRow>words("Keys", KeyRow::keys).weight(2),
        Column.<KeyRow>words("", KeyRow::note).weight(3).hint(KeyRow::note));
  }

  private QuietButton button(Composite bar, Theme theme, String text, String hint, Runnable pressed) {
    QuietButton button = new QuietButton(bar, theme, pressed).text(text).hint(hint);
    buttons.add(button);
    return button;
  }

  private void show() {
    List<KeyRow> rows = KeyRow.of(store.now(), views.get(), filter.words());
    table.show(rows);
    if (rows.isEmpty()) {
      table.list().message(Health.NONE, "No match", "Search by words of a command or by a key, such as Ctrl+L.");
    } else {
      table.list().noMessage();
    }
    table.highlight(filter.words().strip());
  }

  private void selected() {
    recorder.end();
    offer(Optional.empty());
    Optional<KeyRow> row = table.list().selected().stream().findFirst();
    buttons.stream().filter(b -> b != buttons.get(4)).forEach(b -> b.setEnabled(row.isPresent()));
    notice.show(row.map(KeyRow::health).orElse(Health.NONE),
        row.map(r -> r.note().isEmpty() ? r.command().help() : r.note())
            .orElse("Choose a command to change its keys."));
  }

  private void withSelected(Consumer<KeyRow> action) {
    table.list().selected().stream().findFirst().ifPresent(action);
  }

  private void record(KeyRow row, boolean more) {
    offer(Optional.empty());
    Optional<String> fixed = KeyRules.fixed(row.command());
    if (fixed.isPresent()) {
      notice.show(Health.BAD, fixed.get());
      return;
    }
    notice.show(Health.WAITING, "Press the keys for '" + row.command().name() + "'. Esc leaves them as they are.");
    recorder.begin(keys -> recorded(row, keys, more), this::selected);
  }

  private void recorded(KeyRow row, KeySequence key, boolean more) {
    Optional<String> refusal = row.refusal(key);
    if (refusal.isPresent()) {
      notice.show(Health.BAD, refusal.get());
      return;
    }
    Keymap now = store.now();
    List<KeySequence> keys = new ArrayList<>(more ? now.keys(row.command()) : List.of());
    keys.remove(key);
    keys.add(key);
    List<KeyedCommand> holders = now.holders(key, row.command());
    if (holders.isEmpty()) {
      change(row, now.with(row.command(), keys));
    } else {
      notice.show(Health.WARNING, KeyWords.text(key) + " runs " + holders.stream().map(c -> "'" + c.name() + "'")
          .collect(Collectors.joining(", ")) + " now. Take it over, or choose another key.");
      offer(Optional.of(() -> change(row, store.now().taking(row.command(), keys))));
    }
  }

  private void change(KeyRow row, Keymap next) {
    Optional<String> fixed = KeyRules.fixed(row.command());
    if (fixed.isPresent()) {
      notice.show(Health.BAD, fixed.get());
      return;
    }
    store.change(next);
    select(row.command().id());
  }

  private void resetAll() {
    store.change(store.now().usual());
    selected();
  }

  private void offer(Optional<Runnable> take) {
    taking = take.orElse(() -> {});
    takeOver.setVisible(take.isPresent());
    if (take.isPresent()) {
      takeOver.setFocus();
    }
  }
}
