package org.robotui.workbench.internal.pane;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Collectors;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Shell;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.NoticeLine;

/** Which RobotUI this is, and what it runs on: what somebody is asked for who reports a fault. Display thread only. */
public final class AboutDialog {
  /** What its buttons do that others know. */
  public interface Links {
    /** Opens the documentation. */
    void documentation();

    /** Opens the page that names what others have made, and its licences. */
    void licences();

    /** Opens the list of what is installed. */
    void installation();
  }

  private static final int WIDTH = 640;
  private static final int NAME_WIDTH = 90;
  private static final String LICENCE = "Apache License, Version 2.0; those of what others have made: Licences";

  private final Theme theme;
  private final Map<String, String> facts;
  private final Shell shell;
  private final NoticeLine said;

  /**
   * Makes the window.
   *
   * @param facts values by what they are, in their order; the first is the version
   */
  public AboutDialog(Shell parent, Theme theme, Map<String, String> facts, Links links) {
    this.theme = theme;
    this.facts = new LinkedHashMap<>(facts);
    shell = DialogShell.over(parent, theme, "About RobotUI", SWT.NONE);
    shell.setLayout(DialogShell.layout(1, 0, 0));
    Composite head = box(1);
    words(head, Face.TITLE, Role.TEXT, "RobotUI");
    words(head, Face.BODY, Role.DIM, "One workbench for robots of any framework");
    Composite body = box(2);
    this.facts.forEach((name, value) -> fact(body, name, value));
    fact(body, "Licence", LICENCE);
    said = new NoticeLine(shell, theme, Face.BODY);
    buttons(links);
    DialogShell.place(shell, WIDTH, SWT.DEFAULT);
  }

  /** Shows it. */
  public void open() {
    shell.open();
  }

  /** The window, for tests. */
  public Shell shell() {
    return shell;
  }

  /** What is copied. */
  String text() {
    return facts.entrySet().stream().map(fact -> fact.getKey() + ": " + fact.getValue())
        .collect(Collectors.joining("\n", "", "\n"));
  }

  private Composite box(int columns) {
    Composite box = new Composite(shell, SWT.NONE);
    box.setBackground(theme.color(Role.PANEL));
    box.setLayout(DialogShell.layout(columns, 2 * Theme.EDGE, Theme.STEP));
    box.setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
    return box;
  }

  private void fact(Composite parent, String name, String value) {
    GridData first = new GridData(SWT.BEGINNING, SWT.TOP, false, false);
    first.widthHint = NAME_WIDTH;
    new ShortenedLabel(parent, theme, Face.BODY, Role.DIM, name).setLayoutData(first);
    words(parent, Face.BODY, Role.TEXT, value);
  }

  private void words(Composite parent, Face face, Role role, String text) {
    new ShortenedLabel(parent, theme, face, role, text).setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
  }

  private void buttons(Links links) {
    Composite bar = new Composite(shell, SWT.NONE);
    bar.setBackground(theme.color(Role.TITLE));
    bar.setLayout(DialogShell.layout(6, Theme.EDGE, Theme.STEP));
    bar.setLayoutData(new GridData(SWT.FILL, SWT.BOTTOM, true, true));
    DialogShell.button(bar, theme, links::documentation).text("Documentation");
    DialogShell.button(bar, theme, links::licences).text("Licences");
    DialogShell.button(bar, theme, links::installation).text("Installed software\u2026");
    new Gap(bar).setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    DialogShell.button(bar, theme, this::copy).icon(Icon.COPY).text("Copy");
    DialogShell.button(bar, theme, shell::close).icon(Icon.CLOSE).text("Close");
  }

  private void copy() {
    Clipboards.copy(text());
    said.show(Health.OK, "It is in the clipboard.");
  }
}
