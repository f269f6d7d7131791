package org.robotui.uic.parameters.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StackLayout;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.QuietButton;
import org.robotui.uic.parameters.internal.model.Key;
import org.robotui.uic.parameters.internal.model.Panel;
import org.robotui.uic.parameters.internal.model.ParametersModel;
import org.robotui.uic.parameters.internal.model.ParametersViewState;
import org.robotui.uic.parameters.internal.model.Tuner;

/** What is seen of the view: two leaves and a filter above, what became of the last change below. Display thread. */
public final class ParametersSurface implements ViewSurface {
  private static final int FILTER_WIDTH = 180;
  private static final int WIDE_FROM = 520;

  private final UiContext context;
  private final ParametersModel model;
  private final Composite root;
  private final Composite bar;
  private final QuietButton parameters;
  private final QuietButton tuning;
  private final FilterField filter;
  private final NoticeLine notice;
  private final Composite stack;
  private final StackLayout leaves = new StackLayout();
  private final ParameterTree tree;
  private final TunerPane tuner;
  private final ParameterFooter footer;

  /** Makes the controls. */
  public ParametersSurface(Composite parent, UiContext context, ParametersModel model) {
    this.context = context;
    this.model = model;
    Theme theme = context.theme();
    root = Boxes.root(parent, theme, this::down);
    bar = Boxes.bar(root, theme, 3);
    parameters = new QuietButton(bar, theme, () -> leaf(false)).text("Parameters");
    tuning = new QuietButton(bar, theme, () -> leaf(true)).text("Running programs");
    filter = new FilterField(bar, theme, "Filter", this::filter);
    filter.setLayoutData(Boxes.end(FILTER_WIDTH));
    notice = new NoticeLine(root, theme, Face.BODY);
    stack = new Composite(root, SWT.NONE);
    stack.setBackground(theme.color(Role.PANEL));
    stack.setLayoutData(Boxes.fill());
    stack.setLayout(leaves);
    tree = new ParameterTree(stack, theme, model, filter::focus);
    tuner = new TunerPane(stack, theme, model, filter::focus);
    footer = new ParameterFooter(root, theme, model);
    filter.onDown(this::down);
    filter.words(model.look().filter());
    root.addListener(SWT.Resize, e -> arrange());
    root.addListener(SWT.Dispose, e -> model.gone());
  }

  @Override
  public Control control() {
    return root;
  }

  /** Shows what the last tick prepared. */
  public void refresh() {
    if (root.isDisposed()) {
      return;
    }
    ParametersViewState look = model.look();
    if (root.isVisible()) {
      model.seen(System.nanoTime(), look.tuning() ? List.of() : tree.visible());
    }
    buttons(look);
    turn(look.tuning() ? tuner.control() : tree.control());
    if (look.tuning()) {
      tuner.show(look);
    } else {
      tree.show(look);
    }
    boolean changed = Boxes.seen(notice.control(), !look.notice().isEmpty());
    notice.show(Health.WARNING, look.notice());
    if (footer.show(look) | changed) {
      root.layout();
    }
    context.note(note(look));
  }

  ParameterTree tree() {
    return tree;
  }

  TunerPane tuner() {
    return tuner;
  }

  FilterField filterField() {
    return filter;
  }

  /** Each leaf lists other things: words that were typed for one would hide those of the other. */
  void leaf(boolean tunes) {
    if (model.look().tuning() != tunes) {
      filter.words("");
    }
    model.tuning(tunes);
  }

  /** Shows nothing but one parameter, and those whose names begin with its name. */
  public void find(Key parameter) {
    leaf(false);
    filter.words(parameter.name());
    down();
  }

  private void filter(String words) {
    model.filter(words);
    tree.table().highlight(words);
    tuner.servers().highlight(words);
  }

  private boolean down() {
    return (model.look().tuning() ? tuner.servers() : tree.table()).list().control().setFocus();
  }

  private void buttons(ParametersViewState look) {
    int before = width();
    parameters.text("Parameters  " + look.parameters()).checked(!look.tuning());
    tuning.text("Running programs  " + look.servers().size()).checked(look.tuning());
    if (width() != before) {
      bar.layout();
    }
  }

  private int width() {
    return parameters.computeSize(SWT.DEFAULT, SWT.DEFAULT).x + tuning.computeSize(SWT.DEFAULT, SWT.DEFAULT).x;
  }

  private void turn(Control next) {
    if (leaves.topControl != next) {
      leaves.topControl = next;
      stack.layout();
    }
  }

  private void arrange() {
    ((GridData) filter.getLayoutData()).widthHint =
        root.getClientArea().width >= WIDE_FROM ? FILTER_WIDTH : FILTER_WIDTH / 2;
    bar.layout();
  }

  private String note(ParametersViewState look) {
    Optional<Panel> panel = look.panel().filter(p -> look.tuning());
    if (panel.isPresent()) {
      long others =
          model.tuner().map(Tuner::panel).map(p -> p.knobs().stream().filter(k -> !k.isDefault()).count()).orElse(0L);
      return others == 0 ? "" : others + " not at the default";
    }
    long changed = look.rows().stream().filter(row -> row.before().isPresent()).count();
    return look.tuning() || changed == 0 ? "" : changed + " changed";
  }
}
