package org.robotui.workbench.internal.pane;

import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Table;
import org.eclipse.swt.widgets.TableColumn;
import org.eclipse.swt.widgets.TableItem;
import org.robotui.api.host.Match;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.SourceId;
import org.robotui.ui.MatchLook;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.PopupMenu;

/**
 * Every connection of a RUIC, and why it is as it is. The context menu of a port connects it to one of those that fit.
 * Display thread only.
 */
public final class ConnectionsDialog {
  private static final int REFRESH_MILLIS = 500;
  private static final int WIDTH = 1080;
  private static final int HEIGHT = 520;
  private static final int[] WIDTHS = {110, 180, 130, 200, 420};
  private static final String[] TITLES = {"State", "View port", "Type", "Robot port", "Why"};

  private final Theme theme;
  private final Ruic ruic;
  private final Shell shell;
  private final Table table;
  private List<Match> shown = List.of();

  /** Makes the window. */
  public ConnectionsDialog(Shell parent, Theme theme, Ruic ruic) {
    this.theme = theme;
    this.ruic = ruic;
    shell = DialogShell.over(parent, theme, "Connections of " + ruic.name());
    shell.setLayout(new FillLayout());
    table = new Table(shell, SWT.FULL_SELECTION | SWT.SINGLE);
    table.setHeaderVisible(true);
    table.setBackground(theme.color(Role.PANEL));
    table.setForeground(theme.color(Role.TEXT));
    table.setHeaderBackground(theme.color(Role.TITLE));
    table.setHeaderForeground(theme.color(Role.DIM));
    columns();
    table.addListener(SWT.MenuDetect, e -> contextMenu());
    DialogShell.place(shell, WIDTH, HEIGHT);
  }

  /** Shows it and keeps it up to date until it is closed. */
  public void open() {
    refresh();
    shell.open();
  }

  private void columns() {
    for (int i = 0; i < TITLES.length; i++) {
      TableColumn column = new TableColumn(table, SWT.LEFT);
      column.setText(TITLES[i]);
      column.setWidth(WIDTHS[i]);
    }
  }

  private void refresh() {
    if (shell.isDisposed()) {
      return;
    }
    List<Match> now = ruic.snapshot().matches();
    if (!now.equals(shown)) {
      shown = List.copyOf(now);
      fill();
    }
    shell.getDisplay().timerExec(REFRESH_MILLIS, this::refresh);
  }

  private void fill() {
    table.setItemCount(shown.size());
    for (int i = 0; i < shown.size(); i++) {
      Match match = shown.get(i);
      TableItem item = table.getItem(i);
      item.setText(
          new String[]{MatchLook.word(match), match.port().toString(), match.typeName(), MatchLook.peers(match),
              match.reason()});
      item.setForeground(0, theme.color(MatchLook.health(match).role()));
    }
    // The reasons are sentences: as wide as the longest, to be scrolled to, rather than cut.
    table.getColumn(TITLES.length - 1).pack();
  }

  private void contextMenu() {
    int index = table.getSelectionIndex();
    if (index < 0 || shown.get(index).candidates().isEmpty()) {
      return;
    }
    Match match = shown.get(index);
    PopupMenu menu = new PopupMenu(table);
    for (SourceId candidate : match.candidates()) {
      menu.push("Connect to " + candidate, () -> ruic.connect(match.port(), candidate));
    }
    menu.open();
  }
}
