package org.robotui.sim.internal.carmen;

import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.message.IpcRecordMaker;
import org.robotui.carmen.module.IpcModule;
import org.robotui.carmen.module.MessageSender;

/** Publishes what the robot says, whether or not somebody listens: programs of CARMEN do not know either. */
final class Said {
  private final Map<String, MessageSender> senders = new HashMap<>();

  Said(IpcModule module, IpcForms forms, List<String> names) throws IOException {
    for (String name : names) {
      senders.put(name, module.sender(forms.get(name)));
    }
  }

  void say(IpcRecordMaker message) {
    senders.get(message.form().name()).publish(message.build());
  }
}
