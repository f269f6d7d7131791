package org.robotui.workbench.tests;

import java.util.Map;
import org.osgi.framework.FrameworkUtil;
import org.robotui.testkit.osgi.PackedBundle;

/** The bundle whose view misbehaves on the display thread, packed from classes of the tests. */
final class BadBundle {
  private static final String NAME = "org.robotui.tests.badwindow";
  private static final String IMPORTS =
      "org.osgi.framework,org.robotui.api,org.robotui.api.config,org.robotui.api.host,org.robotui.api.port,org.robotui.ui";

  private BadBundle() {}

  static PackedBundle packed() {
    return new PackedBundle(FrameworkUtil.getBundle(BadBundle.class), NAME,
        Map.of("Import-Package", IMPORTS, "Require-Bundle", "org.eclipse.swt"));
  }
}
