package org.robotui.bridge.internal.carry;

import java.util.List;
import java.util.Optional;
import org.robotui.api.bridge.BridgeEnd;
import org.robotui.api.bridge.BridgeTransform;
import org.robotui.api.host.Host;
import org.robotui.api.host.Ruic;
import org.robotui.bridge.internal.TransformTable;

/**
 * What bridges find around them.
 *
 * @param host the robots
 * @param transforms what is installed
 * @param arrival is run when a value waits to be carried, by the thread that received it
 */
record CarryContext(Host host, TransformTable transforms, Runnable arrival) {
  Optional<Ruic> ruic(BridgeEnd end) {
    return host.ruics().stream().filter(ruic -> ruic.name().equals(end.ruic())).findFirst();
  }

  Optional<BridgeTransform> transform(String id) {
    return transforms.find(id);
  }

  List<String> transformIds() {
    return transforms.ids();
  }
}
