package org.robotui.workbench.internal.pane;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.host.CompositionState;
import org.robotui.api.host.RuicFit;
import org.robotui.api.host.ViewFit;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Icons;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.ChoiceField;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.RowTable;
import org.robotui.workbench.internal.model.NewRobotModel;
import org.robotui.workbench.internal.model.NewViewRow;

/**
 * The second step: how the window is laid out, and which views are in it. A click or Space takes a view in or leaves it
 * out. Display thread only.
 */
final class NewViewsPage extends Composite {
  private static final int FIELD_HEIGHT = 28;
  private static final int FIELD_WIDTH = 280;
  private static final int BOX = 15;

  private final Theme theme;
  private final NewRobotModel model;
  private final Runnable changed;
  private final ChoiceField ruic;
  private final ShortenedLabel reason;
  private final RowTable<NewViewRow> table;
  private List<NewViewRow> rows = List.of();

  NewViewsPage(Composite parent, Theme theme, NewRobotModel model, Runnable changed) {
    super(parent, SWT.NONE);
    this.theme = theme;
    this.model = model;
    this.changed = changed;
    setBackground(theme.color(Role.PANEL));
    GridLayout layout = new GridLayout(3, false);
    layout.marginWidth = Theme.EDGE;
    layout.marginHeight = Theme.EDGE;
    layout.horizontalSpacing = Theme.EDGE;
    setLayout(layout);
    new ShortenedLabel(this, theme, Face.SMALL_STRONG, Role.DIM, "LAYOUT")
        .setLayoutData(new GridData(SWT.BEGINNING, SWT.CENTER, false, false));
    ruic = new ChoiceField(this, theme, "The layout", this::chooseRuic);
    GridData field = new GridData(SWT.BEGINNING, SWT.CENTER, false, false);
    field.heightHint = FIELD_HEIGHT;
    field.widthHint = FIELD_WIDTH;
    ruic.control().setLayoutData(field);
    reason = new ShortenedLabel(this, theme, Face.BODY, Role.DIM, "");
    reason.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    table = new RowTable<>(this, theme, List.of(
        Column.words("", (NewViewRow r) -> r.port().isPresent() ? "" : r.chosen() ? "selected" : "not selected")
            .painted(this::box).width(36).weight(0),
        Column.words("View", NewViewRow::label).painted(this::label).hint(NewViewRow::hint).weight(0.8),
        Column.words("State", NewViewRow::state).dot(NewViewRow::health).role(r -> r.health().role()).width(120)
            .weight(0),
        Column.words("Why", NewViewRow::why).role(Role.DIM).weight(3)), NewViewRow::key);
    table.list().named("Views that fit");
    table.list().control().addListener(SWT.MouseUp, this::clicked);
    table.list().control().addListener(SWT.KeyDown, e -> {
      if (e.character == ' ') {
        table.list().selected().stream().findFirst().ifPresent(this::press);
      }
    });
    table.control().setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true, 3, 1));
  }

  /** Shows what fits, as it is known now. */
  void show(CompositionState state) {
    Optional<RuicFit> chosen = model.ruic(state);
    ruic.show(chosen.map(RuicFit::label).orElse("none is installed"));
    reason.show(Role.DIM, chosen.map(RuicFit::reason).orElse(""), chosen.map(RuicFit::help).orElse(""));
    List<NewViewRow> next = chosen.map(r -> NewViewRow.of(state, r, model.views(state), model.connections(state),
        model.decided())).orElse(List.of());
    if (!next.equals(rows)) {
      rows = next;
      table.show(rows);
    }
  }

  /** What is chosen, in a sentence. */
  String summary(CompositionState state) {
    List<String> views = model.views(state);
    long choices = views.stream().flatMap(v -> state.view(v).stream()).flatMap(v -> v.choices().stream())
        .filter(m -> !model.decided().contains(m.port())).count();
    String chosen =
        views.isEmpty() ? "Choose at least one view." : views.size() + (views.size() == 1 ? " view." : " views.");
    return choices == 0 ? chosen
        : chosen + " " + choices + (choices == 1 ? " port has" : " ports have")
            + " several that fit: the plainest was taken.";
  }

  private void chooseRuic() {
    model.state().ifPresent(state -> {
      PopupMenu menu = new PopupMenu(ruic.control());
      String now = model.ruic(state).map(RuicFit::type).orElse("");
      state.ruics().forEach(r -> menu.radio(r.label() + ": " + r.reason(), r.type().equals(now), () -> {
        model.ruic(r.type());
        changed.run();
      }));
      menu.openBelow(ruic.control());
    });
  }

  private void clicked(Event event) {
    if (event.button == 1) {
      rows.stream().filter(r -> table.list().bounds(r.key()).filter(b -> b.contains(event.x, event.y)).isPresent())
          .findFirst().ifPresent(this::press);
    }
  }

  private void press(NewViewRow row) {
    model.state().ifPresent(state -> {
      if (row.port().isPresent()) {
        choose(row, row.port().get(), state);
      } else if (row.chosen() || state.view(row.view()).filter(ViewFit::fits).isPresent()) {
        model.flip(state, row.view());
        changed.run();
      }
    });
  }

  private void choose(NewViewRow row, SourceId port, CompositionState state) {
    PopupMenu menu = new PopupMenu(table.list().control());
    SourceId now = model.connections(state).get(port);
    row.candidates().forEach(c -> menu.radio(c.port(), c.equals(now), () -> {
      model.choose(port, c);
      changed.run();
    }));
    table.list().bounds(row.key())
        .ifPresent(b -> menu.open(table.list().control().toDisplay(b.x + 60, b.y + b.height)));
  }

  private void box(GC gc, Rectangle at, NewViewRow row) {
    if (row.port().isPresent()) {
      return;
    }
    boolean can = row.chosen() || model.state().flatMap(s -> s.view(row.view())).filter(ViewFit::fits).isPresent();
    int top = at.y + (at.height - BOX) / 2;
    gc.setAntialias(SWT.ON);
    if (row.chosen()) {
      gc.setBackground(theme.color(Role.ACCENT));
      gc.fillRoundRectangle(at.x, top, BOX, BOX, 5, 5);
      gc.setForeground(theme.on(Role.ACCENT));
      Icons.paint(gc, Icon.CHECK, at.x + 2, top + 2, BOX - 4);
    } else if (can) {
      gc.setForeground(theme.color(Role.DIM));
      gc.drawRoundRectangle(at.x, top, BOX - 1, BOX - 1, 5, 5);
    }
  }

  private void label(GC gc, Rectangle at, NewViewRow row) {
    int indent = row.port().isPresent() ? 4 * Theme.STEP : 0;
    boolean fits = row.port().isPresent() || row.chosen()
        || model.state().flatMap(s -> s.view(row.view())).filter(ViewFit::fits).isPresent();
    gc.setFont(theme.font(Face.BODY));
    gc.setForeground(theme.color(fits ? Role.TEXT : Role.DIM));
    gc.drawText(row.label(), at.x + indent, at.y + (at.height - gc.textExtent(row.label()).y) / 2, true);
  }

  @Override
  public boolean setFocus() {
    return !table.list().control().isDisposed() && table.list().control().setFocus();
  }
}
