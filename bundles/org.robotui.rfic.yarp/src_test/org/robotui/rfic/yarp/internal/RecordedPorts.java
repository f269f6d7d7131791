package org.robotui.rfic.yarp.internal;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import org.robotui.testkit.recorded.SharedData;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.BottleCodec;
import org.robotui.yarp.wire.YarpFraming;
import org.robotui.yarp.wire.YarpMessage;

/** What real ports of YARP said and answered. */
final class RecordedPorts {
  private RecordedPorts() {}

  static boolean available() {
    return Files.isReadable(SharedData.capture("yarp/connections.csv"));
  }

  static byte[] bytes(String name) throws IOException {
    return Files.readAllBytes(SharedData.capture("yarp/" + name));
  }

  /** The bottles that who connected said. */
  static List<Bottle> bottles(String connection) throws IOException {
    ByteArrayInputStream in = new ByteArrayInputStream(bytes(connection + ".c2s.bin"));
    YarpFraming.readHeader(in);
    List<Bottle> bottles = new ArrayList<>();
    while (in.available() > 0) {
      YarpMessage message = YarpFraming.read(in);
      if (message.data().length > 0) {
        bottles.add(BottleCodec.read(message.data()));
      }
    }
    return bottles;
  }
}
