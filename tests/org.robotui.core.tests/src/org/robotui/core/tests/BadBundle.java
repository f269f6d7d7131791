package org.robotui.core.tests;

import java.util.Map;
import org.robotui.testkit.osgi.PackedBundle;

/** The bundle that misbehaves, packed from classes of the tests. */
final class BadBundle {
  static final String NAME = "org.robotui.tests.bad";

  private static final String IMPORTS =
      "org.osgi.framework,org.robotui.api,org.robotui.api.command,org.robotui.api.config,"
          + "org.robotui.api.host,org.robotui.api.link,org.robotui.api.port,org.robotui.data,"
          + "org.robotui.data.command,org.robotui.data.record,org.robotui.data.status,org.robotui.geometry";

  private BadBundle() {}

  static PackedBundle packed() {
    return new PackedBundle(Bundles.context().getBundle(), NAME, Map.of("Import-Package", IMPORTS));
  }
}
