package org.robotui.workbench.internal.pane;

import java.nio.file.Path;
import java.util.Map;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.program.Program;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.QuietButton;
import org.robotui.workbench.internal.ActiveTheme;

/** How the workbench looks, and where it keeps what users change. Display thread only. */
public final class GeneralPane extends Composite {
  private static final Map<String, String> WORDS =
      Map.of(Themes.DARK, "Dark", Themes.LIGHT, "Light", ActiveTheme.AS_DESKTOP, "As the desktop at the start");

  /**
   * Makes the page.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param chosen the theme that the user has chosen
   * @param change is given the theme that the user chooses now
   * @param folder where things are kept
   */
  public GeneralPane(Composite parent, Theme theme, String chosen, Consumer<String> change, Path folder) {
    super(parent, SWT.NONE);
    setBackground(theme.color(Role.PANEL));
    GridLayout layout = Boxes.grid(1);
    layout.verticalSpacing = 2 * Theme.STEP;
    setLayout(layout);
    title(theme, "Colours");
    Composite themes = Boxes.bar(this, theme, ActiveTheme.choices().size());
    ActiveTheme.choices().forEach(id -> new QuietButton(themes, theme, () -> change.accept(id)).text(WORDS.get(id))
        .hint("Changes the colours of all windows").checked(id.equals(chosen)));
    title(theme, "What you change is kept in");
    new ShortenedLabel(this, theme, Face.BODY, Role.DIM, folder.toString()).setLayoutData(Boxes.line());
    Composite open = Boxes.bar(this, theme, 1);
    new QuietButton(open, theme, () -> Program.launch(folder.toString())).text("Open Folder")
        .hint("Shows the files: keys.yaml has the keys, overlays what you changed in robot UIs");
  }

  private void title(Theme theme, String words) {
    new ShortenedLabel(this, theme, Face.BODY_STRONG, Role.TEXT, words).setLayoutData(Boxes.line());
  }
}
