package org.robotui.yarp.port;

import java.util.Optional;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.wire.YarpStamp;

/**
 * What a port was told.
 *
 * @param from the name of who told it
 * @param bottle what was said
 * @param bytes the same as it came; not to be changed
 * @param stamp its envelope
 */
public record PortArrival(String from, Bottle bottle, byte[] bytes, Optional<YarpStamp> stamp) {}
