package org.robotui.uic.diagnostics.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.RowData;
import org.eclipse.swt.layout.RowLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.DetailSplit;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.QuietButton;
import org.robotui.uic.diagnostics.internal.model.Ask;

/** What is seen of the view while it is shown. Display thread. */
public final class DiagnosticsSurface implements ViewSurface {
  private static final int BESIDE_FROM = 780;
  private static final int TREE_SHARE = 60;
  private static final int FIELD_WIDTH = 150;
  private static final int FIELD_HEIGHT = 26;

  private final UiContext context;
  private final DiagnosticsHands hands;
  private final Composite root;
  private final CountBar counts;
  private final QuietButton problems;
  private final SourceButton source;
  private final FilterField search;
  private final TimeBar time;
  private final DetailSplit halves;
  private final TreeArea tree;
  private final DiagnosticsDetailPane detail;
  private Ask ask = Ask.DEFAULT;

  /** In a part of a window. */
  public DiagnosticsSurface(Composite parent, UiContext context, DiagnosticsHands hands) {
    this.context = context;
    this.hands = hands;
    Theme theme = context.theme();
    root = Boxes.panel(parent, theme, 1);
    Composite bar = bar(theme);
    counts = new CountBar(bar, theme);
    RowData room = new RowData(counts.width(), CountBar.HEIGHT);
    counts.control().setLayoutData(room);
    problems = new QuietButton(bar, theme, () -> hands.ask(ask.problems(!ask.problems()))).text("Problems")
        .hint("Show only what is not OK");
    source = new SourceButton(bar, theme, chosen -> hands.ask(ask.source(chosen)));
    search = new FilterField(bar, theme, "Search", this::search);
    RowData field = new RowData(FIELD_WIDTH, FIELD_HEIGHT);
    search.setLayoutData(field);
    root.addListener(SWT.Resize, e -> {
      room.width = Math.min(counts.width(), root.getSize().x - 2 * Theme.EDGE);
      field.width = Math.min(FIELD_WIDTH, root.getSize().x - 2 * Theme.EDGE);
    });
    search.onDown(this::focusTree);
    time = new TimeBar(root, theme, slot -> hands.ask(ask.at(slot)));
    time.control().setLayoutData(Boxes.line(TimeBar.HEIGHT));
    halves = new DetailSplit(root, theme, TREE_SHARE).besideFrom(BESIDE_FROM, TREE_SHARE).thin();
    tree = new TreeArea(halves.parts(), theme, hands);
    detail = new DiagnosticsDetailPane(halves.parts(), theme, this::closeDetail);
    halves.detail(false);
    tree.list().onFind(search::focus);
    tree.list().control().addListener(SWT.KeyDown, this::key);
  }

  @Override
  public Control control() {
    return root;
  }

  /** Shows what the last tick left. */
  public void show(Frame frame) {
    if (root.isDisposed()) {
      return;
    }
    ask = frame.ask();
    context.note(frame.title());
    counts.show(frame.shown().counts());
    problems.checked(ask.problems());
    source.show(frame.shown().sources(), ask.source());
    time.show(frame.shown());
    tree.show(frame);
    frame.shown().detail().ifPresent(detail::show);
    if (halves.detail(frame.shown().detail().isPresent() && ask.selected().isPresent())) {
      ask.selected().ifPresent(tree.list()::select);
    }
  }

  private Composite bar(Theme theme) {
    Composite bar = Boxes.panel(root, theme, 1);
    bar.setLayoutData(Boxes.line());
    RowLayout layout = new RowLayout(SWT.HORIZONTAL);
    layout.wrap = true;
    layout.center = true;
    layout.spacing = Theme.STEP;
    layout.marginLeft = Theme.EDGE;
    layout.marginRight = 2 * Theme.STEP;
    bar.setLayout(layout);
    return bar;
  }

  private void search(String words) {
    if (!words.equals(ask.search())) {
      hands.ask(ask.search(words));
    }
  }

  private void focusTree() {
    tree.list().control().setFocus();
  }

  private void closeDetail() {
    tree.list().selectNone();
    hands.ask(ask.select(Optional.empty()));
    focusTree();
  }

  private void key(Event event) {
    if (event.keyCode == SWT.ESC) {
      if (ask.slot().isPresent()) {
        hands.ask(ask.at(Optional.empty()));
      } else {
        closeDetail();
      }
    }
  }
}
