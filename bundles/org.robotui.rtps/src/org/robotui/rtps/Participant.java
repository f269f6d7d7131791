package org.robotui.rtps;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.concurrent.ThreadFactory;
import org.robotui.rtps.internal.participant.UdpParticipant;

/**
 * A participant of a DDS domain that speaks RTPS 2.3 over UDP. Any thread may use it.
 *
 * <p>It has two threads: one receives and calls the listeners, one sends what is due (announcements, heartbeats,
 * acknowledgements, repairs) and watches over leases. No call blocks but {@link #open}, {@link #close} and
 * {@link Writer#awaitAcknowledged}.
 */
public interface Participant extends AutoCloseable {

  /**
   * Opens the sockets and begins to announce itself.
   *
   * @param settings which domain, on which network
   * @param threads makes the threads
   * @return the participant
   * @throws IOException if a socket cannot be opened; the message names the port or interface and what may help
   */
  static Participant open(ParticipantSettings settings, ThreadFactory threads) throws IOException {
    return UdpParticipant.open(settings, threads);
  }

  /**
   * What it announces of itself.
   *
   * @return guid, name, addresses
   */
  ParticipantInfo info();

  /**
   * Who else is there.
   *
   * @return the same object always
   */
  Discovery discovery();

  /**
   * Opens a reader of a topic without keys.
   *
   * @param topic its name in DDS, such as {@code rt/chatter}
   * @param type the name of its type in DDS, such as {@code std_msgs::msg::dds_::String_}
   * @param qos what is requested of writers
   * @param userData opaque bytes that are announced with it; may be empty
   * @param listener hears of the samples
   * @return the reader
   * @throws IllegalStateException if the participant is closed
   */
  Reader reader(String topic, String type, Qos qos, ByteBuffer userData, SampleListener listener);

  /**
   * Opens a reader that requests no more than what writers offer: while one of the topic's writers offers less than the
   * preferred quality, less is requested of all of them, and more again when it has gone. Each change makes another
   * endpoint: volatile samples that are written at just that time may be missed.
   *
   * @param topic its name in DDS
   * @param type the name of its type in DDS
   * @param preferred what is requested where all writers offer it
   * @param userData opaque bytes that are announced with it; may be empty
   * @param listener hears of the samples
   * @return the reader
   * @throws IllegalStateException if the participant is closed
   */
  Reader adaptingReader(String topic, String type, Qos preferred, ByteBuffer userData, SampleListener listener);

  /**
   * Opens a writer of a topic without keys.
   *
   * @param topic its name in DDS
   * @param type the name of its type in DDS
   * @param qos what is offered to readers
   * @param userData opaque bytes that are announced with it; may be empty
   * @return the writer
   * @throws IllegalStateException if the participant is closed
   */
  Writer writer(String topic, String type, Qos qos, ByteBuffer userData);

  /**
   * What was counted.
   *
   * @return the figures so far
   */
  ParticipantStatistics statistics();

  /** Takes back all readers and writers, says farewell and ends the threads, in less than a second. */
  @Override
  void close();
}
