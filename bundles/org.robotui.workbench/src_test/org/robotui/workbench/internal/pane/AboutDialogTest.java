package org.robotui.workbench.internal.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.Map;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class AboutDialogTest {
  @Test
  void whatIsCopiedIsWhatIsSeenInItsOrder() {
    Shell parent = new Shell(TestDisplay.get());
    Theme theme = Themes.of(TestDisplay.get(), Themes.LIGHT);
    parent.setBounds(0, 0, 1200, 900);
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("Version", "0.1.0");
    facts.put("Java", "25 in /opt/java");

    AboutDialog dialog = new AboutDialog(parent, theme, facts, new AboutDialog.Links() {
      @Override
      public void documentation() {
        parent.setText("documentation");
      }

      @Override
      public void licences() {
        parent.setText("licences");
      }

      @Override
      public void installation() {
        parent.setText("installation");
      }
    });
    dialog.open();

    assertEquals("Version: 0.1.0\nJava: 25 in /opt/java\n", dialog.text());
    assertTrue(dialog.shell().isVisible());
    parent.dispose();
    theme.dispose();
  }
}
