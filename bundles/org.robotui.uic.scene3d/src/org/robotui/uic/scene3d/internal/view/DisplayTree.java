package org.robotui.uic.scene3d.internal.view;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.SashForm;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.gl.display.DisplayType;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.ViewAction;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.PlainLabel;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RowList;
import org.robotui.uic.scene3d.internal.SceneParts;
import org.robotui.uic.scene3d.internal.model.DisplayRow;
import org.robotui.uic.scene3d.internal.model.Stage;

/** The list of displays with the settings of the one that is chosen below it. Display thread. */
final class DisplayTree {
  private static final int[] SHARES = {55, 45};
  private static final double MEGA = 1e6;

  private final SceneSurface scene;
  private final SceneParts parts;
  private final Composite box;
  private final SashForm split;
  private final RowList<DisplayRow> list;
  private final SettingsPane settings;
  private final PlainLabel total;
  private List<DisplayRow> rows = List.of();
  private boolean told;
  private Optional<String> added = Optional.empty();

  DisplayTree(Composite parent, Theme theme, SceneSurface scene, SceneParts parts) {
    this.scene = scene;
    this.parts = parts;
    box = Boxes.panel(parent, theme, 1);
    Composite bar = Boxes.bar(box, theme, 4);
    PlainLabel title = new PlainLabel(bar, SWT.NONE, theme, Face.BODY_STRONG, Role.TEXT);
    title.setText("Displays");
    title.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    total = new PlainLabel(bar, SWT.NONE, theme, Face.SMALL, Role.DIM);
    QuietButton add = new QuietButton(bar, theme, () -> {}).icon(Icon.PLUS).hint("Add a display");
    add.addListener(SWT.MouseUp, e -> add(add));
    add.addListener(SWT.KeyDown, e -> keyAdd(e, add));
    QuietButton more = new QuietButton(bar, theme, this::reset).icon(Icon.RESTART)
        .hint("Show what the robot offers, in place of this list");
    more.setLayoutData(Boxes.middle());
    split = Boxes.split(box, theme, SWT.VERTICAL);
    split.setLayoutData(Boxes.fill());
    list = new RowList<>(split, theme, new DisplayLook(theme)).named("Displays");
    list.control().addListener(SWT.MouseDown, this::pressed);
    list.control().addListener(SWT.KeyDown, this::key);
    list.onSelect(chosen -> select(chosen.stream().findFirst())).menu(this::actions);
    settings = new SettingsPane(split, theme, parts, scene::refresh);
    split.setWeights(SHARES);
    select(Optional.empty());
  }

  Control control() {
    return box;
  }

  void show(Stage stage) {
    if (!told || !stage.rows().equals(rows)) {
      told = true;
      rows = stage.rows();
      list.show(rows);
      choose();
      rows.stream().filter(r -> settings.shows(r.spec().id())).findFirst().ifPresentOrElse(settings::show,
          () -> select(Optional.empty()));
      if (rows.isEmpty()) {
        list.message(Health.NONE, "No displays", "Add one with +, or take back what the robot offers.");
      } else {
        list.noMessage();
      }
    }
    String words = stage.bytes() == 0 ? "" : Figures.of(stage.bytes() / MEGA, 1, "MB");
    if (!words.equals(total.getText())) {
      total.setText(words);
      total.getParent().layout();
    }
  }

  /** Chooses a display, as soon as it is listed. */
  void choose(String id) {
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
    boolean news = row.isPresent() != (split.getMaximizedControl() == null);
    if (news) {
      split.setMaximizedControl(row.isPresent() ? null : list.control());
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
      row.ifPresent(r -> parts.edits().remove(r.spec().id()));
    } else if (e.keyCode == SWT.F2) {
      row.ifPresent(this::rename);
    }
  }

  private void flip(DisplayRow row) {
    parts.edits().change(row.spec().id(), s -> s.show(!s.shown()));
    scene.refresh();
  }

  private void reset() {
    parts.edits().automatic();
    scene.refresh();
  }

  private void keyAdd(Event e, Control button) {
    if (e.character == ' ' || e.character == SWT.CR) {
      add(button);
    }
  }

  private void add(Control button) {
    PopupMenu menu = new PopupMenu(button, scene::refresh);
    List<DisplayType> kinds = parts.kinds().get().stream().sorted(Comparator.comparing(DisplayType::label)).toList();
    kinds.forEach(k -> menu.push(k.label(), () -> add(k)));
    if (kinds.isEmpty()) {
      menu.push("No bundle brings displays", false, () -> {});
    }
    menu.openBelow(button);
  }

  /** Adds a display, and chooses it. */
  void add(DisplayType kind) {
    added = Optional.of(parts.edits().add(kind.id()));
    scene.refresh();
  }

  private List<ViewAction> actions(List<DisplayRow> chosen) {
    return chosen.stream().findFirst().map(row -> {
      String id = row.spec().id();
      return List.of(
          action(row.spec().shown() ? "Hide" : "Show", () -> flip(row)),
          action("Show all of it",
              () -> parts.model().stage().bounds(id)
                  .ifPresent(b -> scene.go(parts.rig().aim().fit(b, scene.aspect())))),
          action("Rename\u2026 (F2)", () -> rename(row)),
          action("Move up", () -> parts.edits().move(id, -1)),
          action("Move down", () -> parts.edits().move(id, 1)),
          action("Remove (Del)", () -> parts.edits().remove(id)));
    }).orElse(List.of());
  }

  private static ViewAction action(String label, Runnable run) {
    return new ViewAction(label, label, "", Optional.empty(), run);
  }

  private void rename(DisplayRow row) {
    NameDialog.ask(box, "Name", row.name())
        .ifPresent(name -> parts.edits().change(row.spec().id(), s -> s.named(name)));
  }
}
