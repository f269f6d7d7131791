package org.robotui.uic.log.internal.view;

import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.RowData;
import org.eclipse.swt.layout.RowLayout;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.QuietButton;
import org.robotui.uic.log.internal.model.LogFilter;
import org.robotui.uic.log.internal.model.Search;

/** The controls above the list: search, nodes, levels. They wrap where the view is narrow. Display thread. */
final class LogBar {
  private static final int FIELD_WIDTH = 185;
  private static final int FIELD_HEIGHT = 26;

  private final LogHands hands;
  private final FilterField search;
  private final QuietButton expression;
  private final QuietButton nodes;
  private final LevelBar levels;
  private LogFilter filter;
  private boolean nodesShown;

  LogBar(Composite parent, Theme theme, LogHands hands, LogFilter filter, Runnable down) {
    this.hands = hands;
    this.filter = filter;
    Composite root = new Composite(parent, SWT.NONE);
    root.setBackground(theme.color(Role.PANEL));
    root.setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
    root.setLayout(layout());
    search = new FilterField(root, theme, "Search", words -> search(words, this.filter.search().expression()));
    search.setLayoutData(new RowData(FIELD_WIDTH, FIELD_HEIGHT));
    search.onDown(down);
    expression = new QuietButton(root, theme, () -> search(search.words(), !this.filter.search().expression()))
        .text(".*").hint("Search by regular expression");
    nodes = new QuietButton(root, theme, () -> hands.nodes(!nodesShown)).text("Nodes")
        .hint("List the nodes, to show or hide each");
    levels = new LevelBar(root, theme,
        severity -> hands.filter(this.filter.level(severity, !this.filter.levels().contains(severity))));
    RowData place = new RowData(levels.width(), LevelBar.HEIGHT);
    levels.control().setLayoutData(place);
    parent.addListener(SWT.Resize, e -> place.width = Math.min(levels.width(), parent.getSize().x - 4 * Theme.STEP));
    search.words(filter.search().text());
  }

  /** Goes to the search. */
  void find() {
    search.focus();
  }

  void show(Frame frame) {
    filter = frame.filter();
    nodesShown = frame.nodes();
    if (!search.words().equals(filter.search().text())) {
      search.words(filter.search().text());
    }
    expression.checked(filter.search().expression());
    nodes.checked(nodesShown);
    levels.show(frame.shown().counts(), filter.levels());
  }

  private void search(String words, boolean asExpression) {
    if (!words.equals(filter.search().text()) || asExpression != filter.search().expression()) {
      hands.filter(filter.search(Search.of(words, asExpression)));
    }
  }

  private static RowLayout layout() {
    RowLayout layout = new RowLayout(SWT.HORIZONTAL);
    layout.wrap = true;
    layout.center = true;
    layout.spacing = Theme.STEP;
    layout.marginWidth = 2 * Theme.STEP - layout.marginLeft;
    layout.marginHeight = 1;
    return layout;
  }
}
