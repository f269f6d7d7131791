package org.robotui.entity.robotmodel.internal;

import java.util.List;
import org.robotui.api.config.Settings;
import org.robotui.data.RobotDescription;

/** What is to be loaded: another one asks for another load. */
record LoadRequest(RobotDescription description, boolean collision, List<String> packages) {
  static LoadRequest of(RobotDescription description, Settings settings) {
    return new LoadRequest(description, settings.flag(RobotModelType.COLLISION),
        settings.list(RobotModelType.PACKAGES).stream().map(Object::toString).toList());
  }
}
