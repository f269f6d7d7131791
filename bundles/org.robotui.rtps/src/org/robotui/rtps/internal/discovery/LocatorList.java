package org.robotui.rtps.internal.discovery;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.robotui.rtps.Locator;
import org.robotui.rtps.Locators;
import org.robotui.rtps.internal.wire.ParameterValue;
import org.robotui.rtps.internal.wire.WireException;

/** Collects locators, as many as are of use. More are left out: a participant needs no more to be reached. */
final class LocatorList {

  private final List<Locator> unicast = new ArrayList<>();

  private final List<Locator> multicast = new ArrayList<>();

  void unicast(ByteBuffer value) throws WireException {
    add(unicast, ParameterValue.locator(value));
  }

  void multicast(ByteBuffer value) throws WireException {
    add(multicast, ParameterValue.locator(value));
  }

  private static void add(List<Locator> list, Locator locator) {
    if (list.size() < FieldBounds.LOCATORS && !list.contains(locator)) {
      list.add(locator);
    }
  }

  Locators build() {
    return new Locators(unicast, multicast);
  }
}
