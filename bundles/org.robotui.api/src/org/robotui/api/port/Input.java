package org.robotui.api.port;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.robotui.api.replay.StreamHistory;
import org.robotui.data.Data;

/**
 * The view's end of a stream. It is polled, from any thread and without blocking, so that a slow view never slows a
 * robot interface. Sets of sources change while it is used.
 *
 * @param <T> the type of the data
 */
public interface Input<T extends Data> {
  /**
   * What the input has as a whole: the best state of its sources.
   *
   * @return the state
   */
  InputState state();

  /**
   * The sources now connected, in a stable order; of a port with {@link Intake#CHOSEN} the chosen ones that are there.
   *
   * @return the sources
   */
  List<SourceId> sources();

  /**
   * A stream that fits the port.
   *
   * @param id where it comes from
   * @param typeName its data type, for example {@code LaserScan}
   */
  record Candidate(SourceId id, String typeName) {}

  /**
   * What the port fits: of {@link Intake#CHOSEN} all that could be chosen, else what is connected.
   *
   * @return the streams, in a stable order; may be thousands
   */
  List<Candidate> candidates();

  /**
   * Chooses what is taken, in place of what was chosen before. Streams that go on being chosen lose nothing. Called
   * from any thread.
   *
   * @param sources what to take; those that are not there yet are taken when they come
   * @throws IllegalStateException where the port is not {@link Intake#CHOSEN}
   */
  void choose(Set<SourceId> sources);

  /**
   * What one source gives.
   *
   * @param source one of {@link #sources()}
   * @return its state
   */
  InputState state(SourceId source);

  /**
   * The newest value of any source; keyed types are merged per source.
   *
   * @return the value, or none before the first
   */
  Optional<Envelope<T>> latest();

  /**
   * The newest value of one source, merged for keyed types.
   *
   * @param source one of {@link #sources()}
   * @return the value, or none before the first
   */
  Optional<Envelope<T>> latest(SourceId source);

  /**
   * Takes what came since the last call, in the order of arrival: of samples the newest per source, of keyed types what
   * changed, merged, of events and of chosen sources all. One thread at a time may drain.
   *
   * @param consumer is called on this thread
   * @return how many values were taken
   */
  int drain(Consumer<? super Envelope<T>> consumer);

  /**
   * Has the next {@link #drain} give again what holds until something newer comes: the last value of sources whose
   * sender keeps it for late comers, or whose type does not expire, as if they were connected anew. For a view that has
   * forgotten what it took, as the clock of the robot jumped back: call it before draining, on the thread that drains.
   */
  void recall();

  /**
   * All that a recording has of a source, the future too. What is read of it is not asked for by playing: a source need
   * not be chosen for that.
   *
   * @param source one of {@link #candidates()}
   * @return its history; none where the robot is live, or where the source is not there now. Another one than before
   * where the recording was opened anew
   */
  default Optional<StreamHistory> history(SourceId source) {
    return Optional.empty();
  }

  /**
   * Values lost to full queues since the connection was made, and keys given up where a keyed type had too many
   * ({@link org.robotui.data.Keyed#most()}). Values that conflation replaced do not count.
   *
   * @return the count
   */
  long dropped();
}
