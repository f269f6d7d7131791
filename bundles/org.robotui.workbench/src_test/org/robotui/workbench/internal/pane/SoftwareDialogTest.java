package org.robotui.workbench.internal.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.util.List;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.install.SiteFeature;
import org.robotui.testkit.Controls;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.control.QuietButton;
import org.robotui.workbench.internal.model.FakeInstaller;
import org.robotui.workbench.internal.model.SoftwareModel;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class SoftwareDialogTest {
  private static final URI SITE = URI.create("http://localhost/site");

  private final FakeInstaller installer = new FakeInstaller();
  private Shell parent;
  private Theme theme;
  private SoftwareModel model;
  private SoftwareDialog dialog;

  @BeforeEach
  void open() {
    installer.installs(new SiteFeature("lidar", "1.0.0", "Lidar", "sees")).offers(SITE,
        new SiteFeature("lidar", "2.0.0", "Lidar", "sees"));
    installer.remember(SITE);
    parent = new Shell(TestDisplay.get());
    parent.setBounds(0, 0, 1400, 900);
    theme = Themes.of(TestDisplay.get(), Themes.DARK);
    model = new SoftwareModel(installer, Runnable::run, Runnable::run, names -> true);
    dialog = new SoftwareDialog(parent, theme, model);
    dialog.open();
  }

  @AfterEach
  void close() {
    parent.dispose();
    theme.dispose();
  }

  private QuietButton button(int index) {
    List<QuietButton> all = Controls.all(dialog.shell(), QuietButton.class);
    return all.get(index);
  }

  @Test
  void withoutASelectionOnlyUpdatesCanBeLookedFor() {
    assertTrue(button(2).isEnabled());
    assertFalse(button(3).isEnabled());
    assertFalse(button(4).isEnabled());
  }

  @Test
  void allIsUpdatedByTheButton() {
    button(2).press();

    assertEquals("There is nothing newer.", model.sentence());
  }

  @Test
  void theSiteIsForgottenByTheButton() {
    button(1).press();

    assertEquals(List.of(), installer.sites());
    assertFalse(button(1).isEnabled());
  }
}
