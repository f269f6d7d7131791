package org.robotui.uic.body.internal.view;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;
import org.robotui.api.port.InputState;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.DetailSplit;
import org.robotui.ui.control.FilterField;
import org.robotui.uic.body.internal.model.BodyLook;
import org.robotui.uic.body.internal.model.BodyWish;

/** What is seen of the view. Display thread. */
public final class BodySurface implements ViewSurface {
  private static final int WIDEST_FILTER = 180;
  private static final int BESIDE_FROM = 760;
  private static final int TREE_SHARE = 62;

  private final UiContext context;
  private final Supplier<BodyWish> wished;
  private final Consumer<BodyWish> wishes;
  private final Composite root;
  private final DetailSplit halves;
  private final BodyTable table;
  private final PastPane past;

  /** In a part of a window. */
  public BodySurface(Composite parent, UiContext context, Supplier<BodyWish> wished, Consumer<BodyWish> wishes) {
    this.context = context;
    this.wished = wished;
    this.wishes = wishes;
    Theme theme = context.theme();
    root = Boxes.root(parent, theme, this::focus);
    Composite bar = Boxes.bar(root, theme, 1);
    FilterField filter = new FilterField(bar, theme, "Search", this::search);
    filter.setLayoutData(Boxes.end(WIDEST_FILTER));
    halves = new DetailSplit(root, theme, TREE_SHARE).besideFrom(BESIDE_FROM, TREE_SHARE).thin();
    table = new BodyTable(halves.parts(), theme, wished, wishes);
    past = new PastPane(halves.parts(), theme, this::closeDetail);
    halves.detail(false);
    table.list().onFind(filter::focus);
    filter.onDown(this::focus);
    table.list().control().addListener(SWT.KeyDown, e -> {
      if (e.keyCode == SWT.ESC) {
        closeDetail();
      }
    });
  }

  @Override
  public Control control() {
    return root;
  }

  /** Shows what the last tick left. */
  public void show(BodyLook look, BodyWish wish) {
    if (root.isDisposed()) {
      return;
    }
    context.note(title(look));
    table.show(look);
    look.detail().ifPresent(past::show);
    halves.detail(wish.selected().isPresent() && look.detail().isPresent());
  }

  private static String title(BodyLook look) {
    if (look.parts() == 0) {
      return "";
    }
    long wrong = look.lines().stream().filter(line -> line.depth() == 0 && line.health() != Health.OK).count();
    String link = look.state() instanceof InputState.Live ? "" : "  " + StateView.word(look.state());
    return look.parts() + (look.parts() == 1 ? " part" : " parts") + (wrong == 0 ? "" : ", " + wrong + " not well")
        + link;
  }

  private boolean focus() {
    return table.list().control().setFocus();
  }

  private void search(String words) {
    if (!words.equals(wished.get().search())) {
      wishes.accept(wished.get().search(words));
    }
  }

  private void closeDetail() {
    table.list().selectNone();
    wishes.accept(wished.get().select(Optional.empty()));
    focus();
  }
}
