package org.robotui.uic.parameters.internal.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.port.InputState;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.ViewAction;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.RowTable;
import org.robotui.ui.control.SaveDialog;
import org.robotui.uic.parameters.internal.model.Key;
import org.robotui.uic.parameters.internal.model.ParameterRow;
import org.robotui.uic.parameters.internal.model.ParametersModel;
import org.robotui.uic.parameters.internal.model.ParametersViewState;
import org.robotui.uic.parameters.internal.model.ValueText;

/** The parameters as a tree whose values are edited in place. Display thread. */
final class ParameterTree {
  private static final int AHEAD = 10;

  private final ParametersModel model;
  private final TreeCells cells;
  private final RowTable<ParameterRow> table;
  private final ValueEditor editor;
  private int width;

  ParameterTree(Composite parent, Theme theme, ParametersModel model, Runnable find) {
    this.model = model;
    cells = new TreeCells(theme);
    table = new RowTable<>(parent, theme, cells.columns(), ParameterRow::key);
    editor = new ValueEditor((Composite) table.list().control(), theme, model);
    table.list().named("Parameters").onFind(find).onOpen(this::open).menu(this::menu);
    Control canvas = table.list().control();
    canvas.addListener(SWT.KeyDown, this::key);
    canvas.addListener(SWT.MouseDown, this::pressed);
    canvas.addListener(SWT.Paint, e -> seen());
    canvas.addListener(SWT.Resize, e -> resized(canvas.getSize().x));
    canvas.addListener(SWT.MouseVerticalWheel, e -> editor.cancel());
    ((Composite) canvas).getVerticalBar().addListener(SWT.Selection, e -> editor.cancel());
  }

  Control control() {
    return table.control();
  }

  RowTable<ParameterRow> table() {
    return table;
  }

  ValueEditor editor() {
    return editor;
  }

  void show(ParametersViewState look) {
    table.show(look.rows());
    if (!StateView.showsContent(look.state())) {
      message(look.state());
    } else if (!look.rows().isEmpty()) {
      table.list().noMessage();
    } else if (look.parameters() > 0) {
      table.list().message(Health.NONE, "No match",
          "None of " + look.parameters() + " contains these words. Esc clears the filter.");
    } else {
      table.list().message(Health.NONE, "No parameters", "The robot has none now.");
    }
    seen();
  }

  /** What is on the screen, and a little more below, is read. */
  List<Key> visible() {
    return table.list().visible(AHEAD).stream().filter(ParameterRow::parameter).map(ParameterRow::key).toList();
  }

  void edit() {
    selected().filter(row -> row.value().isPresent()).ifPresent(row -> table.list().bounds(row.key()).ifPresent(at -> {
      Rectangle column = cells.column().orElse(at);
      editor.open(row, new Rectangle(column.x, at.y, column.width, at.height));
    }));
  }

  /** A line of words that comes below must not end the typing that it is about. */
  private void resized(int now) {
    if (now != width) {
      width = now;
      editor.cancel();
    }
  }

  private void seen() {
    if (control().isVisible()) {
      model.seen(System.nanoTime(), visible());
    }
  }

  private void message(InputState state) {
    String title = switch (state) {
      case InputState.Failed f -> "No answer";
      case InputState.Waiting w -> "Asking";
      default -> "No robot to ask";
    };
    table.list().message(StateView.health(state), title, state.explanation());
  }

  private void open(ParameterRow row) {
    if (row.namespace()) {
      model.open(row.key(), !row.open());
    } else {
      edit();
    }
  }

  private void key(Event event) {
    Optional<ParameterRow> space = selected().filter(ParameterRow::namespace);
    switch (event.keyCode) {
      case SWT.ARROW_LEFT -> space.ifPresent(row -> model.open(row.key(), false));
      case SWT.ARROW_RIGHT -> space.ifPresent(row -> model.open(row.key(), true));
      case SWT.F2 -> edit();
      case SWT.F5 -> model.refresh();
      default -> {
        if (event.keyCode == 'z' && (event.stateMask & SWT.MOD1) != 0) {
          model.undo();
        }
      }
    }
  }

  private void pressed(Event event) {
    editor.cancel();
    selected().filter(row -> event.button == 1 && row.namespace() && event.x < TreeCells.lead(row))
        .ifPresent(row -> model.open(row.key(), !row.open()));
  }

  private Optional<ParameterRow> selected() {
    return table.list().selected().stream().findFirst();
  }

  private List<ViewAction> menu(List<ParameterRow> rows) {
    List<ViewAction> actions = new ArrayList<>();
    rows.stream().findFirst().ifPresent(row -> {
      if (row.value().isPresent()) {
        actions.add(action("edit", "Edit (F2)", this::edit));
        row.before().ifPresent(before -> actions
            .add(action("was", "Copy earlier value: " + brief(before), () -> Clipboards.copy(before))));
        actions.add(action("value", "Copy value", () -> Clipboards.copy(row.value().map(ValueText::of).orElse(""))));
      }
      actions.add(action("name", "Copy name", () -> Clipboards.copy(row.key().name())));
      actions.add(action("export", "Export as YAML\u2026", () -> export(row)));
    });
    return actions;
  }

  private static String brief(String text) {
    return text.length() > 40 ? text.substring(0, 40) + "\u2026" : text;
  }

  private static ViewAction action(String id, String label, Runnable run) {
    return new ViewAction(id, label, "", Optional.empty(), run);
  }

  private void export(ParameterRow row) {
    String name = row.label().isEmpty() ? "parameters" : row.label();
    SaveDialog.ask(table.control(), "Export parameters", name + ".yaml", "*.yaml")
        .ifPresent(file -> model.export(row.key(), file));
  }
}
