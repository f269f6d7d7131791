package org.robotui.rtps.internal.endpoint;

import org.robotui.rtps.EntityId;
import org.robotui.rtps.internal.wire.SequenceSet;

/**
 * Sends what readers and writers say to those of another participant. Safe for all threads, and never blocks: what the
 * network does not take is lost, as on any bad link.
 */
public interface EndpointOutlet {

  /** Collects submessages to one destination into as few datagrams as there can be; sent when it is closed. */
  interface Batch extends AutoCloseable {

    /** A change that fits into a datagram. */
    void data(EntityId reader, EntityId writer, Change change);

    /** A fragment of one that does not, counted from 1. */
    void fragment(EntityId reader, EntityId writer, Change change, int fragmentSize, long number);

    /** What a writer has. */
    void heartbeat(EntityId reader, EntityId writer, long first, long last, int count, boolean answer);

    /** The same of a writer whose application says that it is alive; nobody has to answer. */
    void alive(EntityId reader, EntityId writer, long first, long last, int count);

    /** Numbers of a writer that never come: from the start to the base of the set, and those in it. */
    void gap(EntityId reader, EntityId writer, long start, SequenceSet set);

    /** What a reader has, and what it lacks. */
    void acknowledge(EntityId reader, EntityId writer, SequenceSet missing, int count, boolean answer);

    /** Fragments that a reader lacks. */
    void missingFragments(EntityId reader, EntityId writer, long sequence, SequenceSet missing, int count);

    @Override
    void close();
  }

  /** Begins to collect. */
  Batch to(Destination destination);
}
