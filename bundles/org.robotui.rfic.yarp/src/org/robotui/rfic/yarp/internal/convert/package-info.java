/** What is made of what ports say. */
package org.robotui.rfic.yarp.internal.convert;
