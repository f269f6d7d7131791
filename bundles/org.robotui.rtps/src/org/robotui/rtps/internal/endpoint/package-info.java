/**
 * Readers and writers by what they keep for each remote end: what came and lacks, what was acknowledged and is asked
 * for. They know no sockets: what they say goes to an {@link org.robotui.rtps.internal.endpoint.EndpointOutlet}, and
 * the time is that of {@link org.robotui.rtps.internal.endpoint.Timers}.
 */
package org.robotui.rtps.internal.endpoint;
