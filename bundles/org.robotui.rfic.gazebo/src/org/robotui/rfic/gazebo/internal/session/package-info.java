/** One node among those of a partition, and its topics as ports. */
package org.robotui.rfic.gazebo.internal.session;
