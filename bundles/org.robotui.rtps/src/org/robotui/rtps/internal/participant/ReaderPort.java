package org.robotui.rtps.internal.participant;

import java.util.List;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Guid;
import org.robotui.rtps.internal.endpoint.Change;
import org.robotui.rtps.internal.endpoint.ReaderCore;

/** A reader, as what comes from the network sees it. */
interface ReaderPort {

  EntityId entity();

  ReaderCore core();

  /** Takes what is complete and in order, on the receiving thread, without a lock. */
  void deliver(Guid writer, List<Change> changes);
}
