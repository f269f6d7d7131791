package org.robotui.ui.display;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.ViewAction;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.DetailSplit;
import org.robotui.ui.control.NameDialog;
import org.robotui.ui.control.PlainLabel;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RowList;

/**
 * A list, with the settings of the one that is chosen below it: add, name, order, colour, hide, remove. Display thread.
 */
public final class DisplayPane {
  /** What the pane needs of its view. */
  public interface Host {
    /**
     * What one is called.
     *
     * @return for example {@code display}
     */
    String noun();

    /**
     * What is listed.
     *
     * @return takes what the user changes
     */
    DisplayList list();

    /**
     * The kinds of which one can be added.
     *
     * @return in any order
     */
    List<DisplayKind> kinds();

    /** The user has changed something: shows it soon. */
    void refresh();

    /**
     * Goes to one, so that all of it is seen.
     *
     * @param id of it
     */
    void showAllOf(String id);
  }

  private static final int LIST_SHARE = 55;
  private static final double MEGA = 1e6;

  private final Host host;
  private final Composite box;
  private final DetailSplit split;
  private final RowList<DisplayRow> list;
  private final SettingsPane settings;
  private final PlainLabel total;
  private List<DisplayRow> rows = List.of();
  private boolean told;
  private Optional<String> added = Optional.empty();

  /**
   * An empty list.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param host the view
   */
  public DisplayPane(Composite parent, Theme theme, Host host) {
    this.host = host;
    String title = title(host.noun());
    box = Boxes.panel(parent, theme, 1);
    Composite bar = Boxes.bar(box, theme, 4);
    PlainLabel heading = new PlainLabel(bar, SWT.NONE, theme, Face.BODY_STRONG, Role.TEXT);
    heading.setText(title);
    heading.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    total = new PlainLabel(bar, SWT.NONE, theme, Face.SMALL, Role.DIM);
    QuietButton add = new QuietButton(bar, theme, () -> {}).icon(Icon.PLUS).hint("Add a " + host.noun());
    add.addListener(SWT.MouseUp, e -> add(add));
    add.addListener(SWT.KeyDown, e -> keyAdd(e, add));
    QuietButton more = new QuietButton(bar, theme, this::reset).icon(Icon.RESTART)
        .hint("Show what the robot offers, in place of this list");
    more.setLayoutData(Boxes.middle());
    split = new DetailSplit(box, theme, LIST_SHARE);
    list = new RowList<>(split.parts(), theme, new DisplayLook(theme)).named(title);
    list.control().addListener(SWT.MouseDown, this::pressed);
    list.control().addListener(SWT.KeyDown, this::key);
    list.onSelect(chosen -> select(chosen.stream().findFirst())).menu(this::actions);
    settings = new SettingsPane(split.parts(), theme, host.list(), host::refresh);
    select(Optional.empty());
  }

  /**
   * What stands in the layout.
   *
   * @return the control
   */
  public Control control() {
    return box;
  }

  /**
   * Shows what there is.
   *
   * @param listed in order
   * @param bytes the memory of all of them; 0 where that is not told
   */
  public void show(List<DisplayRow> listed, long bytes) {
    if (!told || !listed.equals(rows)) {
      told = true;
      rows = listed;
      list.show(rows);
      choose();
      rows.stream().filter(r -> settings.shows(r.spec().id())).findFirst().ifPresentOrElse(settings::show,
          () -> select(Optional.empty()));
      if (rows.isEmpty()) {
        list.message(Health.NONE, "No " + host.noun() + "s", "Add one with +, or take back what the robot offers.");
      } else {
        list.noMessage();
      }
    }
    String words = bytes == 0 ? "" : Figures.of(bytes / MEGA, 1, "MB");
    if (!words.equals(total.getText())) {
      total.setText(words);
      total.getParent().layout();
    }
  }

  /**
   * Chooses one, as soon as it is listed.
   *
   * @param id of it
   */
  public void choose(String id) {
    added = Optional.of(id);
    choose();
  }

  /** What a user just added, as soon as it is listed: its settings are what is wanted next. */
  private void choose() {
    rows.stream().filter(r -> added.filter(r.spec().id()::equals).isPresent()).findFirst().ifPresent(row -> {
      added = Optional.empty();
      select(Optional.of(row));
      list.select(row.spec().id());
    });
  }

  private void select(Optional<DisplayRow> row) {
    row.ifPresent(settings::show);
    if (split.detail(row.isPresent())) {
      // The list has become shorter: what was pressed may lie below its edge.
      row.ifPresent(r -> list.select(r.spec().id()));
    }
  }

  private void pressed(Event e) {
    if (e.button == 1 && e.x < DisplayLook.BOX_END) {
      rows.stream().filter(r -> list.bounds(r.spec().id()).filter((Rectangle at) -> at.contains(e.x, e.y)).isPresent())
          .findFirst().ifPresent(this::flip);
    }
  }

  private void key(Event e) {
    Optional<DisplayRow> row = list.selected().stream().findFirst();
    if (e.character == ' ') {
      row.ifPresent(this::flip);
    } else if (e.keyCode == SWT.DEL) {
      row.ifPresent(r -> host.list().remove(r.spec().id()));
    } else if (e.keyCode == SWT.F2) {
      row.ifPresent(this::rename);
    }
  }

  private void flip(DisplayRow row) {
    host.list().change(row.spec().id(), s -> s.show(!s.shown()));
    host.refresh();
  }

  private void reset() {
    host.list().automatic();
    host.refresh();
  }

  private void keyAdd(Event e, Control button) {
    if (e.character == ' ' || e.character == SWT.CR) {
      add(button);
    }
  }

  private void add(Control button) {
    PopupMenu menu = new PopupMenu(button, host::refresh);
    List<DisplayKind> kinds = host.kinds().stream().sorted(Comparator.comparing(DisplayKind::label)).toList();
    kinds.forEach(k -> menu.push(k.label(), () -> add(k)));
    if (kinds.isEmpty()) {
      menu.push("No bundle brings " + host.noun() + "s", false, () -> {});
    }
    menu.openBelow(button);
  }

  /** Adds one, and chooses it. */
  private void add(DisplayKind kind) {
    added = Optional.of(host.list().add(kind.id()));
    host.refresh();
  }

  private List<ViewAction> actions(List<DisplayRow> chosen) {
    return chosen.stream().findFirst().map(row -> {
      String id = row.spec().id();
      return List.of(
          action(row.spec().shown() ? "Hide" : "Show", () -> flip(row)),
          action("Show all of it", () -> host.showAllOf(id)),
          action("Rename\u2026 (F2)", () -> rename(row)),
          action("Move up", () -> host.list().move(id, -1)),
          action("Move down", () -> host.list().move(id, 1)),
          action("Remove (Del)", () -> host.list().remove(id)));
    }).orElse(List.of());
  }

  private static ViewAction action(String label, Runnable run) {
    return new ViewAction(label, label, "", Optional.empty(), run);
  }

  private void rename(DisplayRow row) {
    NameDialog.ask(box, "Name", row.name()).ifPresent(name -> host.list().change(row.spec().id(), s -> s.named(name)));
  }

  private static String title(String noun) {
    return Character.toUpperCase(noun.charAt(0)) + noun.substring(1) + "s";
  }
}
