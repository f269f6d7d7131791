/**
 * Bytes of RTPS as values and back: messages of submessages, parameter lists, encapsulations, times. Both byte orders.
 * Every length is checked before anything is made of it; payloads are views of the bytes that came.
 *
 * <p>Nothing here knows what was said before: see {@code internal.endpoint} for that.
 */
package org.robotui.rtps.internal.wire;
