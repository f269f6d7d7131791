package org.robotui.workbench.internal.pane;

import java.net.URI;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Shell;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.ChoiceField;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.NameDialog;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RowTable;
import org.robotui.workbench.internal.model.FeatureRow;
import org.robotui.workbench.internal.model.SoftwareModel;

/**
 * What is installed and what an update site offers; installs, updates and removes while robots are shown. Display
 * thread only.
 */
public final class SoftwareDialog {
  private static final int WIDTH = 960;
  private static final int HEIGHT = 600;
  private static final String NO_SITE = "no site: add the address of one";

  private final Theme theme;
  private final SoftwareModel model;
  private final Shell shell;
  private final ChoiceField site;
  private final RowTable<FeatureRow> table;
  private final NoticeLine said;
  private final QuietButton add;
  private final QuietButton forget;
  private final QuietButton update;
  private final QuietButton remove;
  private final QuietButton install;

  /** Makes the window. */
  public SoftwareDialog(Shell parent, Theme theme, SoftwareModel model) {
    this.theme = theme;
    this.model = model;
    shell = DialogShell.over(parent, theme, "Install software");
    shell.setLayout(DialogShell.layout(1, 0, 0));
    Composite head = bar(4);
    new ShortenedLabel(head, theme, Face.BODY, Role.DIM, "Update site");
    site = new ChoiceField(head, theme, "Update site", this::sites);
    GridData wide = new GridData(SWT.FILL, SWT.CENTER, true, false);
    wide.heightHint = DialogShell.BUTTON_HEIGHT;
    site.control().setLayoutData(wide);
    add = button(head, Icon.PLUS, "Add Site\u2026", this::add);
    forget = button(head, Icon.MINUS, "Forget Site", model::forget);
    table = new RowTable<>(shell, theme, columns(), FeatureRow::id);
    table.control().setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    table.list().named("Features that are installed or offered").onSelect(rows -> buttons());
    table.onOrder(this::show);
    said = new NoticeLine(shell, theme, Face.BODY);
    Composite foot = bar(5);
    update = button(foot, Icon.RESTART, "Update All", model::update)
        .hint("Install newer versions of all that is installed, from all sites");
    new Gap(foot).setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    remove = button(foot, Icon.MINUS, "Remove", () -> selected().ifPresent(model::remove));
    install = button(foot, Icon.SAVE, "Install", () -> selected().ifPresent(model::install));
    button(foot, Icon.CLOSE, "Close", shell::close);
    DialogShell.place(shell, WIDTH, HEIGHT);
    model.onChange(this::show);
    show();
  }

  /** Shows it, and what is there. */
  public void open() {
    shell.open();
    model.look();
  }

  /** The window. */
  public Shell shell() {
    return shell;
  }

  private static List<Column<FeatureRow>> columns() {
    return List.of(
        Column.words("Feature", FeatureRow::name).weight(1.2).order((a, b) -> a.name().compareToIgnoreCase(b.name())),
        Column.words("Installed", FeatureRow::installedVersion).role(Role.DIM).weight(0).width(170),
        Column.words("On the site", FeatureRow::offeredVersion)
            .role(row -> row.isNew() ? Role.ACCENT : Role.DIM).weight(0).width(170),
        Column.words("What it is for", FeatureRow::description).role(Role.DIM).weight(2));
  }

  private void show() {
    if (shell.isDisposed()) {
      return;
    }
    List<FeatureRow> rows = model.rows();
    table.show(table.sorted(rows));
    if (rows.isEmpty()) {
      table.list().message(Health.NONE, "Nothing to show", model.isBusy() ? "It is being read."
          : "This RobotUI was not made by an installer, or no site is known.");
    } else {
      table.list().noMessage();
    }
    site.show(model.site().map(URI::toString).orElse(NO_SITE));
    said.show(model.health(), model.sentence());
    buttons();
  }

  private void buttons() {
    boolean free = !model.isBusy();
    Optional<FeatureRow> row = selected();
    add.setEnabled(free);
    forget.setEnabled(free && model.site().isPresent());
    update.setEnabled(free);
    remove.setEnabled(free && row.filter(r -> r.installed().isPresent()).isPresent());
    install.setEnabled(free && row.filter(FeatureRow::isNew).isPresent());
    install.text(row.filter(r -> r.isNew() && r.installed().isPresent()).isPresent() ? "Update" : "Install");
  }

  private Optional<FeatureRow> selected() {
    return table.list().selected().stream().findFirst();
  }

  private void sites() {
    if (model.isBusy()) {
      return;
    }
    PopupMenu menu = new PopupMenu(site.control());
    for (URI each : model.sites()) {
      menu.radio(each.toString(), model.site().filter(each::equals).isPresent(), () -> model.choose(each));
    }
    menu.push("Add Site\u2026", this::add);
    menu.openBelow(site.control());
  }

  private void add() {
    NameDialog.ask(site.control(), "Address of the update site", "http://", SoftwareModel::isSite)
        .map(URI::create).ifPresent(model::choose);
  }

  private Composite bar(int columns) {
    Composite bar = new Composite(shell, SWT.NONE);
    bar.setBackground(theme.color(Role.TITLE));
    bar.setLayout(DialogShell.layout(columns, Theme.EDGE, 0));
    bar.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    return bar;
  }

  private QuietButton button(Composite bar, Icon icon, String label, Runnable action) {
    return DialogShell.button(bar, theme, action).icon(icon).text(label);
  }
}
